#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"
#include "core/session/measurement.h"

namespace alidade {

// What the two positions must agree on whatever the intersection is: a rigid arc keeps its radius, and half a
// turn about an axis along x leaves x alone. The fit leaves both free, so none of it reaches a residual.
// Where R0 or the intersection itself is known with its σ, the fit has to agree with that, too.

/// How far one such condition fails.
struct Closure {
  enum class Of {
    Radius,         ///< R at 180° less that at 0°
    Centre,         ///< Δx at 180° less that at 0°
    NominalRadius,  ///< R, of two free ones their mean, less R0
    Reference,      ///< Δd less the reference
  };

  Of of = Of::Radius;
  double value = 0;   ///< misclosure, mm
  double sigma = 0;   ///< its standard uncertainty, mm, from readings (by s0), effects, pointing zeros,
                      ///< distance and what it is held against
  double chance = 1;  ///< that it fails by so much or more by that alone, 0…1

  /// Its size in σ.
  double sigmas() const { return std::abs(value) / sigma; }
};

/// With its chance by Student's distribution; `degreesOfFreedom` behind σ, may be infinite.
Closure closureOf(Closure::Of of, double value, double sigma, double degreesOfFreedom);

/// "radius", "centre", "nominal_radius", "reference".
std::string_view nameOf(Closure::Of of);

/// `fit` is of `measurement`. The radius is left out where the model has one for both arcs, and R0 where the
/// model takes it as observed or no σ is stated; without arcs at 0° and at 180° only R0 is left, and nothing
/// where the readings do not determine the fit.
std::vector<Closure> closuresOf(const Measurement& measurement, const JointFit& fit);

/// The misclosure between two arcs of the fit without its chance, which takes longer than all the rest.
struct Misclosure {
  double value = 0, sigma = 0;
  double scaledSigma = 0;  ///< the part of σ that s0 scales
};

/// `of`: the radius or the centre; `at0`, `at180`: indices of the arcs; `scale`: s0. Absent where they have
/// no such unknown each.
std::optional<Misclosure> misclosureOf(const JointFit& fit, Closure::Of of, std::size_t at0,
                                       std::size_t at180, double scale);

/// At a risk of 0.1 %: more than what is accounted for separates the positions.
bool fails(const Closure& closure);

}  // namespace alidade
