#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"
#include "core/session/measurement.h"

namespace alidade {

// Conditions on the two positions that hold for any intersection: a rigid arc keeps its radius, and half a
// turn about an axis along x keeps x. The fit leaves x free, and also the radius unless the model shares it,
// so violations do not appear in residuals. If R0 or Δd is known with its σ, the fit must also agree with the
// known value. Repeats must agree with the first position at their axis, zeros of one mark with each other.

/// The misclosure of one such condition.
struct Closure {
  enum class Of {
    Radius,         ///< R at 180° minus that at 0°
    Centre,         ///< Δx at 180° minus that at 0°
    NominalRadius,  ///< R, or the mean of two free ones, minus R0
    Repeat,         ///< Δx, Δy or R of a repeated position minus that of the first at its axis
    Reference,      ///< Δd minus the reference
    ZeroAzimuth,    ///< α0 of a later position minus that of the first, as a length at the distance L
    ZeroElevation,  ///< the same difference of elevations, up positive
  };

  Of of = Of::Radius;
  double value = 0;   ///< misclosure, mm
  double sigma = 0;   ///< its standard uncertainty, mm, from readings (by s0), effects, pointing zeros,
                      ///< distance and the known value
  double chance = 1;  ///< probability that the sources of σ alone cause this size or more, 0…1

  /// The position, by its axis and repeat, and the quantity.
  struct Repeated {
    int axisDeg = 0, repeat = 2;
    Unknown::Kind quantity = Unknown::Kind::CentreX;  ///< or CentreY or Radius

    bool operator==(const Repeated&) const = default;
  };
  std::optional<Repeated> repeated = {};  ///< of a Repeat; for zeros, only the later position is set

  bool isOfZeros() const { return of == Of::ZeroAzimuth || of == Of::ZeroElevation; }
  /// Its size in σ.
  double sigmas() const { return std::abs(value) / sigma; }
};

/// Adds the probability from Student's distribution; `degreesOfFreedom` of σ may be infinite.
Closure closureOf(Closure::Of of, double value, double sigma, double degreesOfFreedom);

/// "radius", "centre", "nominal_radius", "repeat", "reference", "zeros".
std::string_view nameOf(Closure::Of of);

/// `fit` is of `measurement`. The radius is omitted if the model shares it between both arcs. R0 is omitted
/// if it is an observation of the model or has no stated σ. Without arcs at 0° and at 180° only R0 remains;
/// the list is empty if the fit is undetermined.
std::vector<Closure> closuresOf(const Measurement& measurement, const JointFit& fit);

/// Fits every arc with its own centre and radius (`JointFitOptions::isApart`). Absent if no axis is measured
/// again or the readings do not determine every arc. `starts`, `options`: as for the common fit.
std::optional<JointFit> fitApart(const Measurement& measurement, const std::vector<Circle>& starts,
                                 JointFitOptions options);

/// Differences of repeated positions from the first at their axes, in the order of the arcs; of radii only if
/// these are free. `apart`: from `fitApart` of `measurement`.
std::vector<Closure> repeatsOf(const Measurement& measurement, const JointFit& apart);

/// Differences between zeros of one mark (`commonZeros`), in the order of the arcs, minus the change of the
/// orientation by the error terms of `fit`. `options`: of `fit`; σ is √2 σ of a zero, independent of the
/// scatter of readings.
std::vector<Closure> zeroClosuresOf(const Measurement& measurement, const JointFit& fit,
                                    const JointFitOptions& options);

/// The misclosure between two arcs of the fit without its chance, which is by far the slowest part.
struct Misclosure {
  double value = 0, sigma = 0;
  double scaledSigma = 0;  ///< the part of σ that s0 scales
};

/// `quantity`: the radius or a coordinate of the centre; `first`, `other`: indices of the arcs; value: other
/// minus first; `scale`: s0. Absent unless the fit has an unknown of its own for each arc.
std::optional<Misclosure> misclosureOf(const JointFit& fit, Unknown::Kind quantity, std::size_t first,
                                       std::size_t other, double scale);

/// Is the misclosure unexplained at a risk of 0.1 %?
bool fails(const Closure& closure);

}  // namespace alidade
