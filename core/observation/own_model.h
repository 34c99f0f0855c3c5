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

/// Where a reading is taken, for the formulas of the user's own effects.
struct OwnPlace {
  const OwnModel* model;
  /// All but s and the directions with their circles.
  FormulaArguments row;
  double horizontalZero = 0;  ///< α0 as read, rad
  double zeroElevation = 0;   ///< e0, rad
  VerticalCircle circle = VerticalCircle::Zenith;
  bool isZero = false;  ///< of a pointing zero
};

/// The arguments of a formula at these directions, rad: face 1 equivalents, `e` above the horizon.
FormulaArguments argumentsAt(const OwnPlace& place, double a, double e);

/// What one unit of an own term (mm or rad) does to a carrier, with its slopes.
struct OwnShare {
  ErrorTerm term;
  FormCarrier carrier;
  double value = 0;         ///< mm or rad per unit
  double byArcAngle = 0;    ///< its derivative by φ
  double byA = 0, byE = 0;  ///< by the directions
};

/// Evaluates the user's own effects. Not for several threads at once: each problem makes its own. What has no
/// finite value is 0.
class OwnModel {
 public:
  /// `effects` may be null: then nothing acts.
  explicit OwnModel(std::shared_ptr<const OwnEffects> effects);

  /// Of lines that displace the target or the slider reading, at φ on an arc as it is read without errors.
  std::span<const OwnShare> ofGuideway(const OwnPlace& place, const PlanePoint<double>& centre, double radius,
                                       double distance, double phi, int axisDeg) const;
  /// Of lines of circles, at the directions as read before them, face 1 equivalents.
  std::span<const OwnShare> ofCircles(const OwnPlace& place, double a, double e) const;

  /// The place of a row, or of a position's pointing zero, by what is stated of it; `phi` of the slider.
  OwnPlace placeOf(const Measurement& measurement, const ArcMeasurement& arc, const Sighting& row,
                   double phi) const;
  OwnPlace zeroOf(const Measurement& measurement, const ArcMeasurement& arc) const;

  /// How many values so far were not finite.
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

/// By how much the user's own effects displace a target, mm, or a slider reading, rad.
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
