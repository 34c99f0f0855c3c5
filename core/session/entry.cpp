#include "core/session/entry.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <sstream>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"
#include "core/session/row_fields.h"
#include "core/session/session_fields.h"

namespace alidade {

namespace {

// Compensators work within some 4′; a tilt of a degree or more was typed in another unit.
constexpr double largestTiltArcsec = 3600;

// Limits of known sizes in any unit of the catalogue. A much smaller σ would make weights lose digits.
constexpr double leastKnownSigma = 1e-6, largestKnown = 1e6;

bool isBlank(const std::string& text) {
  return text.empty() || (!isDigit(text.front()) && plainSigns(text).empty());
}

template <typename Value>
std::optional<std::string> sentence(const Result<Value>& result) {
  if (result) return std::nullopt;
  return result.problem().what;
}

std::optional<std::string> sentence(const std::optional<Problem>& problem) {
  return problem ? std::optional(problem->what) : std::nullopt;
}

}  // namespace

Result<std::optional<double>> numberEntry(const NumberRule& rule, const std::string& text) {
  if (isBlank(text)) {
    if (rule.whenEmpty) return Problem{Phrase::of(rule.whenEmpty)};
    return rule.fallback;
  }
  const Result<double> value = parseNumber(text);
  if (!value) return value.problem();
  const bool aboveLow = rule.lowBound == Bound::Included ? *value >= rule.low : *value > rule.low;
  if (!aboveLow || !(*value < rule.high)) {
    return Problem{Phrase::of(rule.refusal, quotation(text))};
  }
  return std::optional(*value);
}

Result<std::optional<double>> numberEntry(std::string_view field, const std::string& text) {
  const SessionField* own = sessionFieldNamed(field);
  assert(own && std::holds_alternative<NumberRule>(own->rule));
  return numberEntry(std::get<NumberRule>(own->rule), text);
}

Result<double> knownValueEntry(const std::string& text) {
  if (isBlank(text)) return 0.0;
  const Result<double> value = parseNumber(text);
  if (value && !(std::abs(*value) < largestKnown))
    return Problem{Phrase::of("%1 is out of range: it must be below 1000000 in size", quotation(text))};
  return value;
}

Result<double> knownSigmaEntry(const std::string& text) {
  if (isBlank(text)) return Problem{Phrase::of("is empty: type the standard uncertainty of the known size")};
  const Result<double> sigma = parseNumber(text);
  if (sigma && !(*sigma >= leastKnownSigma && *sigma < largestKnown))
    return Problem{
        Phrase::of("%1 is out of range: it must be at least 0.000001 and below 1000000", quotation(text))};
  return sigma;
}

Result<std::optional<int>> wholeEntry(const WholeRule& rule, const std::string& text) {
  if (isBlank(text)) return rule.fallback;
  const Result<int> value = parseWhole(text);
  if (!value) return value.problem();
  if (*value < rule.low || *value > rule.high) return Problem{Phrase::of(rule.refusal, quotation(text))};
  return std::optional(*value);
}

Result<std::optional<Angle>> angleEntry(const AngleRule& rule, const std::string& text,
                                        VerticalCircle circle) {
  if (rule.mayBeEmpty && isBlank(text)) return std::optional<Angle>();
  const Result<Angle> angle = parseAngle(text);
  if (!angle) return angle.problem();
  const double lowDegrees = circle == VerticalCircle::Elevation ? rule.lowOfElevation : rule.low;
  const Angle low = Angle::fromDegrees(lowDegrees), high = Angle::fromDegrees(rule.high);
  if (*angle >= low && (*angle < high || (rule.isHighIncluded && *angle == high)))
    return std::optional(*angle);
  const std::string lowest = lowDegrees < 0 ? "−" + fixedText(-lowDegrees, 0) : "0";
  return Problem{Phrase::of("%1 lies outside %2°…%3°: check the degrees", quotation(text), lowest,
                            fixedText(rule.high, 0))};
}

Result<std::optional<Angle>> tiltEntry(const std::string& text) {
  if (isBlank(text)) return std::optional<Angle>();
  const Result<double> tilt = parseNumber(text);
  if (!tilt) return tilt.problem();
  if (std::abs(*tilt) < largestTiltArcsec) return std::optional(Angle::fromArcseconds(*tilt));
  return Problem{
      Phrase::of("%1 is out of range: a tilt must be below 3600 arcseconds in size", quotation(text))};
}

Result<std::optional<Corrections>> correctionsEntry(const std::string& text) {
  std::istringstream words(text);
  std::optional<Corrections> corrections;
  bool isNone = false;
  for (std::string word; words >> word;) {
    const auto known = std::ranges::find(correctionSwitches, word, &CorrectionSwitch::key);
    const bool isOther = known == std::end(correctionSwitches) && word != noCorrections;
    if (isOther || isNone || (corrections && word == noCorrections))
      return Problem{
          Phrase::of("%1 names no corrections: type one or more of inclination, standing_axis, collimation "
                     "and tilting_axis, separated by blanks, or the word none",
                     quotation(text))};
    isNone = word == noCorrections;
    if (!corrections) corrections.emplace();
    if (!isNone) (*corrections).*known->isOn = true;
  }
  return corrections;
}

Result<int> axisEntry(const std::string& text) {
  if (isBlank(text)) return Problem{Phrase::of("is empty: type the rotation of the axis, 0 or 180")};
  const Result<double> value = parseNumber(text);
  if (value && (*value == 0 || *value == 180)) return static_cast<int>(*value);
  return Problem{Phrase::of("%1 is no position of the axis: type 0 or 180", quotation(text))};
}

Result<CircleUnit> circleUnitEntry(const std::string& text) {
  if (text.empty() || text == "dms") return CircleUnit::Dms;
  if (text == "degrees") return CircleUnit::Degrees;
  if (text == "gon") return CircleUnit::Gon;
  return Problem{Phrase::of("%1 is no unit of angles: choose dms, degrees or gon", quotation(text))};
}

CircleUnit circleUnitOf(const Session& session) {
  const auto unit = circleUnitEntry(session.instrument.angleUnit);
  return unit ? *unit : CircleUnit::Dms;
}

const char* keyOf(VerticalCircle circle) {
  return circle == VerticalCircle::Zenith ? "zenith" : "elevation";
}

Result<VerticalCircle> verticalCircleEntry(const std::string& text) {
  if (text.empty() || text == "zenith") return VerticalCircle::Zenith;
  if (text == "elevation") return VerticalCircle::Elevation;
  return Problem{Phrase::of("%1 is no kind of vertical circle: choose zenith or elevation", quotation(text))};
}

Result<PointingZeros> pointingZerosEntry(const std::string& text) {
  if (text.empty()) return PointingZeros::Unstated;
  if (text == "each") return PointingZeros::Each;
  if (text == "one") return PointingZeros::One;
  return Problem{Phrase::of("%1 is no way to sight the pointing zeros: choose each or one", quotation(text))};
}

Result<ArcPlane> arcPlaneEntry(const std::string& text) {
  if (text.empty() || text == "vertical") return ArcPlane::Vertical;
  if (text == "square") return ArcPlane::Square;
  return Problem{Phrase::of("%1 is no plane of the arc: choose vertical or square", quotation(text))};
}

Result<ZeroIs> zeroIsEntry(const std::string& text) {
  if (text.empty()) return ZeroIs::Unstated;
  if (text == "mark") return ZeroIs::Mark;
  if (text == "normal") return ZeroIs::Normal;
  if (text == "unknown") return ZeroIs::Unknown;
  return Problem{
      Phrase::of("%1 is no target of a pointing zero: choose mark, normal or unknown", quotation(text))};
}

Result<Measurand> measurandEntry(const std::string& text) {
  if (text.empty() || text == "intersection") return Measurand::Intersection;
  if (text == "distance") return Measurand::Distance;
  return Problem{
      Phrase::of("%1 is no quantity for a tolerance: choose intersection or distance", quotation(text))};
}

Result<VerticalAngleRelation> verticalAngleEntry(const std::string& text) {
  if (text.empty() || text == "exact") return VerticalAngleRelation::Exact;
  if (text == "planar") return VerticalAngleRelation::Planar;
  return Problem{
      Phrase::of("%1 is no relation for the vertical angle: choose exact or planar", quotation(text))};
}

Result<RadiusModel> radiusModelEntry(const std::string& text) {
  if (text.empty() || text == "free") return RadiusModel::Free;
  if (text == "common") return RadiusModel::Common;
  if (text == "known") return RadiusModel::Known;
  return Problem{Phrase::of("%1 is no radius model: choose free, common or known", quotation(text))};
}

std::optional<std::chrono::sys_days> dayOf(const std::string& text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return std::nullopt;
  const auto part = [&text](std::size_t at, std::size_t length) -> std::optional<int> {
    const std::string digits = text.substr(at, length);
    if (!std::all_of(digits.begin(), digits.end(), isDigit)) return std::nullopt;
    return std::stoi(digits);
  };
  const auto year = part(0, 4), month = part(5, 2), day = part(8, 2);
  if (!year || !month || !day) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  return date.ok() ? std::optional(std::chrono::sys_days(date)) : std::nullopt;
}

std::optional<Problem> dateProblem(const std::string& text) {
  if (text.empty() || dayOf(text)) return std::nullopt;
  return Problem{Phrase::of("%1 is no date: type year-month-day, such as 2018-01-31", quotation(text))};
}

std::optional<std::string> entryProblem(const Session& session, const std::string& field,
                                        const std::string& text) {
  if (const SessionField* own = sessionFieldNamed(field)) return sentence(entryProblem(*own, text));
  // If the kind of circle is unknown, the wider range of the elevation circle applies.
  const auto known = verticalCircleEntry(session.geometry.verticalCircle);
  const VerticalCircle circle = known ? *known : VerticalCircle::Elevation;
  constexpr std::string_view ofRows = "readings.";
  if (field.starts_with(ofRows)) {
    const RowField* own = rowFieldNamed(std::string_view(field).substr(ofRows.size()));
    return own ? sentence(entryProblem(*own, text, circle)) : std::nullopt;
  }
  if (field.ends_with(".known.value")) return sentence(knownValueEntry(text));
  if (field.ends_with(".known.sigma")) return sentence(knownSigmaEntry(text));
  if (field == "pointing_zero.horizontal") return sentence(angleEntry(horizontalRule, text, circle));
  if (field == "pointing_zero.vertical") return sentence(angleEntry(verticalRule, text, circle));
  const bool isFurtherCircle = field.ends_with(".horizontal") || field.ends_with(".vertical");
  if (field.starts_with("pointing_zero.") && isFurtherCircle && !text.empty())
    return sentence(angleEntry(field.ends_with(".horizontal") ? horizontalRule : verticalRule, text, circle));
  if (field == "axis_deg") return sentence(axisEntry(text));
  if (field.ends_with(".date")) return sentence(dateProblem(text));
  return std::nullopt;
}

}  // namespace alidade
