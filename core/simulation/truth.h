#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/angle.h"
#include "core/observation/error_term.h"
#include "core/session/measurement.h"
#include "core/simulation/foreign_effect.h"

namespace alidade {

/// The size of one error term, in the unit of the catalogue.
struct TrueSize {
  ErrorTerm term = ErrorTerm::Collimation;
  double value = 0;
};

/// A jump that turns the instrument at one moment.
struct OrientationJump {
  double moment = 0.5;         ///< share of the session's rows taken before the jump, in (0, 1)
  Angle horizontal, vertical;  ///< steps of the circle readings, converted to face 1
};

/// A pointing zero misread in face 1, before the rows of its position: it shifts all readings of that
/// position.
struct TrueWrongZero {
  int axisDeg = 0;
  Angle horizontal, vertical;  ///< the zero reads this much too little; in face 1
  int repeat = 1;              ///< the repeat at this axis
};

/// A radial form error of any order, outside the catalogue: A cos ns + B sin ns.
struct FormHarmonic {
  int order = 7;
  double cosine = 0, sine = 0;  ///< A and B, mm
};

/// One row whose circles were misread or mistyped.
struct TrueGrossError {
  int axisDeg = 0, round = 1, point = 1, face = 1;
  Angle horizontal, vertical;  ///< added to the circle readings
  int repeat = 1;              ///< the repeat at this axis
};

/// Position numbers in truth files, with alternating axes: 0 at 0°, 1 at 180°, 2 at 0° again, …
struct NumberedPosition {
  int axisDeg = 0, repeat = 1;

  int number() const { return 2 * (repeat - 1) + (axisDeg == 0 ? 0 : 1); }
  static NumberedPosition of(int number) { return {number % 2 == 0 ? 0 : 180, number / 2 + 1}; }
};

/// All properties of a simulated session that its fit does not know. Lengths in mm, in the frame o0.
///
/// The guideway turns about an axis at y = axisHeight. Its centre is off that axis by the intersection Δd, so
/// y(0°) = axisHeight + Δd and y(180°) = axisHeight − Δd.
struct Truth {
  std::uint64_t seed = 0;
  std::string protocol;

  double distance = 2405;  ///< L; the session states it with an error of `sigmaDistance`
  double radius = 400;
  double centreX = 0, axisHeight = 0, intersection = 0;
  Angle horizontalZero = Angle::fromDegrees(332);  ///< α0 in the first position
  /// β0 of a perfect instrument at the height of the axis: 90° on a zenith circle and 0° on an elevation
  /// circle.
  Angle verticalZero = Angle::fromDegrees(90);
  ArcPlane plane = ArcPlane::Vertical;  ///< matters if the instrument is not at the axis height
  Angle sliderZero;                     ///< slider reading at s = 0

  std::vector<TrueSize> effects;               ///< each term at most once
  std::shared_ptr<const OwnEffects> own = {};  ///< the user's own, which `effects` may hold; null: none
  std::optional<OrientationJump> jump = {};
  std::optional<TrueWrongZero> wrongZero = {};
  std::optional<FormHarmonic> harmonic = {};
  std::optional<ForeignEffect> foreign = {};
  std::vector<TrueGrossError> grossErrors = {};
  /// True noise of the circle readings divided by the stated noise. Zeros and slider have the stated noise.
  double noiseFactor = 1;

  // Values that the session states.
  double nominalRadius = 400, sigmaDistance = 0;
  Angle sigmaHorizontal = Angle::fromArcseconds(2), sigmaVertical = Angle::fromArcseconds(2);
  Angle sigmaZero = Angle::fromArcseconds(2), sigmaSlider = Angle::fromArcseconds(5);
  VerticalCircle verticalCircle = VerticalCircle::Zenith;
  std::optional<double> sigmaReference = {};  ///< mm; if set, the session states Δd with an error of that σ

  /// Each zero is sighted in both faces, before the rows of its position and after them; drift and jump act
  /// on them as on the rows.
  bool sightsZerosInFull = false;

  Angle placeSpread = Angle::fromArcseconds(60);  ///< 1σ of the slider's places about the planned ones
  Angle typingStep = Angle::fromArcseconds(0.1);  ///< readings are rounded to this
};

/// A typical guideway without effects: Δx and axis height within ±2 mm, Δd within ±3 mm, the radius spread by
/// 0.15 mm (1σ) about 400 mm, the horizontal circle in any orientation.
Truth drawTruth(std::uint64_t seed);

/// The error terms in the model's own units.
ErrorTerms<double> errorsOf(const Truth& truth);

}  // namespace alidade
