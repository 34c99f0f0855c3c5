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
// Where R0 or the intersection itself is known with its σ, the fit has to agree with that, too, and positions
// of one axis with each other.

/// How far one such condition fails.
struct Closure {
  enum class Of {
    Radius,         ///< R at 180° less that at 0°
    Centre,         ///< Δx at 180° less that at 0°
    NominalRadius,  ///< R, of two free ones their mean, less R0
    Repeat,         ///< Δx, Δy or R of a position measured again less that of the first at its axis
    Reference,      ///< Δd less the reference
    ZeroAzimuth,    ///< α0 of a later position less that of the first, as far as they go at the distance L
    ZeroElevation,  ///< the same of the zeros' elevations, up positive
  };

  Of of = Of::Radius;
  double value = 0;   ///< misclosure, mm
  double sigma = 0;   ///< its standard uncertainty, mm, from readings (by s0), effects, pointing zeros,
                      ///< distance and what it is held against
  double chance = 1;  ///< that it fails by so much or more by that alone, 0…1

  /// Which position, by its axis and the how many-th there it is, and what of it.
  struct Repeated {
    int axisDeg = 0, time = 2;
    Unknown::Kind quantity = Unknown::Kind::CentreX;  ///< or CentreY or Radius

    bool operator==(const Repeated&) const = default;
  };
  std::optional<Repeated> repeated = {};  ///< of a Repeat; of zeros the later position alone

  bool isOfZeros() const { return of == Of::ZeroAzimuth || of == Of::ZeroElevation; }
  /// Its size in σ.
  double sigmas() const { return std::abs(value) / sigma; }
};

/// With its chance by Student's distribution; `degreesOfFreedom` behind σ, may be infinite.
Closure closureOf(Closure::Of of, double value, double sigma, double degreesOfFreedom);

/// "radius", "centre", "nominal_radius", "repeat", "reference", "zeros".
std::string_view nameOf(Closure::Of of);

/// `fit` is of `measurement`. The radius is left out where the model has one for both arcs, and R0 where the
/// model takes it as observed or no σ is stated; without arcs at 0° and at 180° only R0 is left, and nothing
/// where the readings do not determine the fit.
std::vector<Closure> closuresOf(const Measurement& measurement, const JointFit& fit);

/// Every arc with a centre and a radius of its own (`JointFitOptions::isApart`), where an axis is measured
/// again and the readings fix all of them. `starts`, `options`: of the fit with those in common.
std::optional<JointFit> fitApart(const Measurement& measurement, const std::vector<Circle>& starts,
                                 JointFitOptions options);

/// What positions measured again disagree by with the first at their axes, in the order taken; of radii only
/// where they are free. `apart`: from `fitApart` of `measurement`.
std::vector<Closure> repeatsOf(const Measurement& measurement, const JointFit& apart);

/// What zeros of one mark (`commonZeros`) differ by beyond what the error terms of `fit` do to the
/// orientation between them, in the order taken. `options`: of `fit`; σ is √2 σ of a zero, whatever the
/// readings scatter.
std::vector<Closure> zeroClosuresOf(const Measurement& measurement, const JointFit& fit,
                                    const JointFitOptions& options);

/// The misclosure between two arcs of the fit without its chance, which takes longer than all the rest.
struct Misclosure {
  double value = 0, sigma = 0;
  double scaledSigma = 0;  ///< the part of σ that s0 scales
};

/// `quantity`: the radius or a coordinate of the centre; `first`, `other`: indices of the arcs, the other
/// less the first; `scale`: s0. Absent where they have no such unknown each.
std::optional<Misclosure> misclosureOf(const JointFit& fit, Unknown::Kind quantity, std::size_t first,
                                       std::size_t other, double scale);

/// At a risk of 0.1 %: more than what is accounted for separates the positions.
bool fails(const Closure& closure);

}  // namespace alidade
