#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/angle.h"
#include "core/base/angle_text.h"
#include "core/base/result.h"
#include "core/session/measurement.h"

namespace alidade {

// The rules for single entries: the valid texts of a field and the meaning of an empty one.

/// Any text.
struct FreeText {};

enum class Bound { Included, Excluded };

/// A number in the unit of its field.
struct NumberRule {
  double low;
  Bound lowBound;
  double high;                      ///< always excluded
  std::optional<double> fallback;   ///< value of an empty text; absent: none
  const char* refusal;              ///< sentence on a number out of range, %1
  const char* whenEmpty = nullptr;  ///< sentence on an empty required field; null: optional
};

/// The number, or the fallback for an empty text.
Result<std::optional<double>> numberEntry(const NumberRule& rule, const std::string& text);
/// The number by the rule of the session's `field`, which must be a number field.
Result<std::optional<double>> numberEntry(std::string_view field, const std::string& text);

/// The known value of a parameter of an effect, in the parameter's unit; empty: 0.
Result<double> knownValueEntry(const std::string& text);
/// The standard uncertainty of a known size, > 0.
Result<double> knownSigmaEntry(const std::string& text);

/// A whole number from `low` to `high`.
struct WholeRule {
  int low, high;
  std::optional<int> fallback;  ///< value of an empty text; absent: none
  const char* refusal;          ///< sentence on a number out of range, %1
};

/// An angle in the range of a circle, in degrees; `low` is included.
struct AngleRule {
  double low, lowOfElevation;  ///< lower limit; `lowOfElevation` applies to elevation circles
  double high;
  bool isHighIncluded = false;
  bool mayBeEmpty = false;
};

/// The number, or the fallback for an empty text.
Result<std::optional<int>> wholeEntry(const WholeRule& rule, const std::string& text);

/// The angle; absent for an empty text if the rule allows it.
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
/// The word of a row whose instrument had all switches off.
inline constexpr std::string_view noCorrections = "none";

/// A compensator reading typed in arcseconds, below 3600″ in size; absent for an empty text.
Result<std::optional<Angle>> tiltEntry(const std::string& text);

/// The switches that were on; absent for an empty text, which means unknown.
Result<std::optional<Corrections>> correctionsEntry(const std::string& text);

/// The rotation of the axis in degrees: 0 or 180.
Result<int> axisEntry(const std::string& text);

/// "dms" (default), "degrees" or "gon".
Result<CircleUnit> circleUnitEntry(const std::string& text);
/// The unit of the session's instrument; degrees, minutes and seconds if its text is invalid.
CircleUnit circleUnitOf(const Session& session);

Result<VerticalCircle> verticalCircleEntry(const std::string& text);
/// "zenith" or "elevation", as in files.
const char* keyOf(VerticalCircle circle);
Result<Measurand> measurandEntry(const std::string& text);
Result<PointingZeros> pointingZerosEntry(const std::string& text);
Result<ArcPlane> arcPlaneEntry(const std::string& text);
Result<ZeroIs> zeroIsEntry(const std::string& text);
Result<VerticalAngleRelation> verticalAngleEntry(const std::string& text);
Result<RadiusModel> radiusModelEntry(const std::string& text);

/// The day of a text such as "2018-01-31"; absent if it is no date.
std::optional<std::chrono::sys_days> dayOf(const std::string& text);

/// Returns the reason why `text` is not a date; an empty text is allowed.
std::optional<Problem> dateProblem(const std::string& text);

}  // namespace alidade
