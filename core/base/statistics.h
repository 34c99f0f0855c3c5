#pragma once

namespace alidade {

/// Probability that χ² with `degreesOfFreedom` > 0 exceeds `chiSquare` ≥ 0.
double chiSquareUpperTail(double chiSquare, double degreesOfFreedom);

/// Probability that F with `numerator` and `denominator` > 0 degrees of freedom exceeds `ratio` ≥ 0; the
/// denominator may be infinite.
double fUpperTail(double ratio, double numerator, double denominator);

/// k such that a Student variable with `degreesOfFreedom` (> 0, may be infinite: normal) lies within ±k with
/// probability `coverage` in (0, 1).
double coverageFactor(double coverage, double degreesOfFreedom);

}  // namespace alidade
