#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/arc/arc_fit.h"
#include "core/base/finding.h"

namespace alidade {

// What an arc's readings can and cannot carry, in words.

/// Why the places sighted fix no circle before any fit: fewer than three of them differ by more than the
/// stated noise.
std::optional<std::string> tooFewPlaces(const Measurement& measurement,
                                        const std::vector<PlanePoint<double>>& places);

/// The sentence for places on a straight line.
std::string straightLineSentence();

/// Why the fitted circle is none: from the stated noise alone its radius is uncertain by more than a third of
/// itself (1σ), so the sagitta drowns in the noise and the linear theory behind every σ no longer holds.
std::optional<std::string> radiusUndetermined(const ArcFit& fit);

/// The angle the sighted places span, seen from the fitted centre, in (0, 2π].
Angle arcSpan(const ArcFit& fit);

/// Findings on a fit that stands: no redundancy, the same reading typed twice, scatter that does not go with
/// the stated noise, a short arc, a radius far from the nominal one, no convergence.
std::vector<Finding> arcFindings(const Measurement& measurement, const ArcMeasurement& arc,
                                 const ArcFit& fit);

}  // namespace alidade
