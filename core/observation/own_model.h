#pragma once

#include <cmath>
#include <span>
#include <type_traits>
#include <vector>

#include "core/observation/error_term.h"
#include "core/observation/guideway.h"
#include "core/session/measurement.h"

namespace alidade {

class OwnModel;

/// The circumstances of a reading, as arguments for the formulas of the user's own effects.
struct OwnPlace {
  const OwnModel* model;
  /// All arguments except the directions and the circle readings, which `argumentsAt` adds.
  FormulaArguments row;
  double horizontalZero = 0;  ///< α0 as read, rad
  double zeroElevation = 0;   ///< e0, rad
  VerticalCircle circle = VerticalCircle::Zenith;
  bool isZero = false;  ///< the reading sights a pointing zero
};

/// The arguments of a formula at these directions, rad: face 1 equivalents, `e` above the horizon.
FormulaArguments argumentsAt(const OwnPlace& place, double a, double e);

/// The effect of one unit (mm or rad) of an own term on a carrier, with its derivatives.
struct OwnShare {
  ErrorTerm term;
  FormCarrier carrier;
  double value = 0;         ///< mm or rad per unit
  double byArcAngle = 0;    ///< its derivative by φ
  double byA = 0, byE = 0;  ///< its derivatives by a and e
};

/// Evaluates the user's own effects. Not thread-safe: each thread needs its own object. Values that are not
/// finite count as 0.
class OwnModel {
 public:
  /// `effects` may be null: there are none.
  explicit OwnModel(std::shared_ptr<const OwnEffects> effects);

  /// The displacements of the target or the slider reading at φ, for circle readings without errors.
  std::span<const OwnShare> ofGuideway(const OwnPlace& place, const PlanePoint<double>& centre, double radius,
                                       double distance, double phi, int axisDeg) const;
  /// The displacements of circle readings. `a`, `e`: face 1 equivalents without these effects, rad.
  std::span<const OwnShare> ofCircles(const OwnPlace& place, double a, double e) const;

  /// The place of a row, or of a position's pointing zero; `phi`: arc angle of the slider.
  OwnPlace placeOf(const Measurement& measurement, const ArcMeasurement& arc, const Sighting& row,
                   double phi) const;
  OwnPlace zeroOf(const Measurement& measurement, const ArcMeasurement& arc) const;

  /// Number of values so far that were not finite.
  std::size_t notFinite() const { return m_notFinite; }

 private:
  struct Line {
    std::size_t entry, line;
    FormCarrier carrier;
    bool actsOnZeros, turnsWithFace;
    std::vector<std::size_t> amplitudes;
  };

  template <typename Slopes>
  std::span<const OwnShare> shares(bool ofCircles, const OwnPlace& place, const Slopes& slopes) const;

  std::shared_ptr<const OwnEffects> m_effects;
  std::vector<FormulaEvaluator> m_evaluators;  ///< of each entry
  std::vector<Line> m_lines;
  mutable std::vector<OwnShare> m_shares;
  mutable std::size_t m_notFinite = 0;
};

template <typename T>
double plainValue(const T& number) {
  if constexpr (std::is_arithmetic_v<T>)
    return number;
  else
    return number.value();
}

/// The displacement of a target, mm, or of a slider reading, rad, by the user's own effects.
template <typename T>
struct OwnDisplacement {
  T radial, tangential, across, x, y, z, slider;
};

template <typename T>
OwnDisplacement<T> ownDisplacement(std::span<const OwnShare> shares, const ErrorTerms<T>& errors,
                                   const T& phi) {
  const T zero = T(phi * 0.0), off = phi - plainValue(phi);
  OwnDisplacement<T> sum{zero, zero, zero, zero, zero, zero, zero};
  T OwnDisplacement<T>::*const parts[] = {&OwnDisplacement<T>::radial, &OwnDisplacement<T>::tangential,
                                          &OwnDisplacement<T>::across, &OwnDisplacement<T>::x,
                                          &OwnDisplacement<T>::y,      &OwnDisplacement<T>::z};
  for (const OwnShare& share : shares) {
    T& part = share.carrier == FormCarrier::Slider ? sum.slider
                                                   : sum.*parts[static_cast<std::size_t>(share.carrier)];
    const T factor = share.value + T(share.byArcAngle * off);
    part += errors[share.term] * factor;
  }
  return sum;
}

}  // namespace alidade
