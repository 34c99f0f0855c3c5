#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/angle.h"
#include "core/base/circle_unit.h"
#include "core/base/result.h"
#include "core/session/measurement.h"

namespace alidade {

// The rules for single entries: what a text in one field may be and what an empty one stands for.

/// A number in the unit of its field, in range. Empty text is the field's default, or nothing where it has
/// none. `field` is named as for `entryProblem`; asking for a field that holds no number is a bug.
Result<std::optional<double>> numberEntry(std::string_view field, const std::string& text);

/// What is known of a number of an effect, in any unit; empty: 0.
Result<double> knownValueEntry(const std::string& text);
/// Its standard uncertainty, > 0.
Result<double> knownSigmaEntry(const std::string& text);

/// A whole number from `low` to `high`.
struct WholeRule {
  int low, high;
  std::optional<int> fallback;  ///< what an empty text stands for; absent: for nothing
  const char* refusal;          ///< of a number out of range, for `Phrase::of` with the number
};

/// An angle in the range of a circle, in degrees; `low` is included.
struct AngleRule {
  double low, lowOfElevation;  ///< the second where the vertical circle reads elevations
  double high;
  bool isHighIncluded = false;
  bool mayBeEmpty = false;
};

/// The number, or the fallback of an empty text.
Result<std::optional<int>> wholeEntry(const WholeRule& rule, const std::string& text);

/// The angle; nothing for an empty text where the rule allows one.
Result<std::optional<Angle>> angleEntry(const AngleRule& rule, const std::string& text,
                                        VerticalCircle circle);

/// A switch of an instrument, by its word in a row's `corrections`.
struct CorrectionSwitch {
  std::string_view key;
  bool Corrections::*isOn;
};
inline constexpr CorrectionSwitch correctionSwitches[] = {{"inclination", &Corrections::inclination},
                                                          {"standing_axis", &Corrections::standingAxis},
                                                          {"collimation", &Corrections::collimation},
                                                          {"tilting_axis", &Corrections::tiltingAxis}};
/// The word of a row whose instrument had all of them off.
inline constexpr std::string_view noCorrections = "none";

/// What a compensator read, in arcseconds; nothing for an empty text.
Result<std::optional<Angle>> tiltEntry(const std::string& text);

/// The words of what was on; nothing for an empty text, which says that it is not known.
Result<std::optional<Corrections>> correctionsEntry(const std::string& text);

/// 0 or 180.
Result<int> axisEntry(const std::string& text);

/// "dms", also empty, "degrees" or "gon".
Result<CircleUnit> circleUnitEntry(const std::string& text);
/// That of the session's instrument; degrees, minutes and seconds where its text means nothing.
CircleUnit circleUnitOf(const Session& session);

Result<VerticalCircle> verticalCircleEntry(const std::string& text);
Result<Measurand> measurandEntry(const std::string& text);
Result<PointingZeros> pointingZerosEntry(const std::string& text);
Result<ArcPlane> arcPlaneEntry(const std::string& text);
Result<ZeroIs> zeroIsEntry(const std::string& text);
Result<VerticalAngleRelation> verticalAngleEntry(const std::string& text);
Result<RadiusModel> radiusModelEntry(const std::string& text);

/// Why `text` is no date; an empty one is allowed.
std::optional<Problem> dateProblem(const std::string& text);

}  // namespace alidade
