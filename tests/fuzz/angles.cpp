#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/base/utf8.h"
#include "core/exchange/recording.h"
#include "core/session/measurement.h"
#include "core/session/row_fields.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/targets.h"

namespace alidade::fuzz {

namespace {

constexpr std::array fields = {"axis_deg",
                               "pointing_zero.horizontal",
                               "pointing_zero.vertical",
                               "geometry.distance_mm",
                               "geometry.sigma_distance_mm",
                               "geometry.radius_mm",
                               "acceptance.coverage",
                               "acceptance.tolerance_mm",
                               "instrument.sigma_horizontal_arcsec",
                               "measured_on",
                               "model.vertical_angle",
                               "model.radius",
                               "geometry.vertical_circle"};

/// A parsed angle is finite, and parses again from its formatted text.
void checkAngle(std::string_view text) {
  const Result<Angle> angle = parseAngle(text);
  if (!angle) return require(!firstIllFormedByte(angle.problem().what), "a refusal that is no text");
  require(std::isfinite(angle->radians()), "an angle that is no number");
  constexpr double mostDegrees = 1e6;
  constexpr int decimals = 9;
  if (std::abs(angle->degrees()) > mostDegrees) return;
  for (const AngleSigns signs : {AngleSigns::Typewriter, AngleSigns::Primes}) {
    const Result<Angle> again = parseAngle(formatDms(*angle, decimals, signs));
    require(static_cast<bool>(again), "an angle that was written cannot be read");
    // The tolerance is half of the last decimal, plus the rounding of a double of that many arcseconds.
    const double most = 0.5e-9 + 1e-15 * std::abs(angle->arcseconds());
    require(std::abs(again->arcseconds() - angle->arcseconds()) <= 2 * most,
            "an angle that changes when written");
  }
  const double inTurn = wrapped(*angle, Angle::fromDegrees(180)).degrees();
  require(inTurn >= 0 && inTurn < 360, "a wrapped angle outside the turn");
}

void checkNumber(std::string_view text) {
  const Result<double> number = parseNumber(text);
  if (!number) return require(!number.problem().what.empty(), "a refusal without words");
  require(std::isfinite(*number), "a number that is none");
  const Result<double> again = parseNumber(shortestText(*number));
  require(again && *again == *number, "a number that changes when written");
  require(!displayText(*number, 3).empty() && !displayShortest(*number).empty(), "a number without words");
}

void checkField(const std::string& field, const std::string& text) {
  static const Session session = blankSession();
  if (const auto problem = entryProblem(session, field, text))
    require(!problem->empty() && !firstIllFormedByte(*problem), "a refusal that is no text");
}

void checkFields(const std::string& text) {
  for (const char* field : fields) checkField(field, text);
  for (const RowField& field : rowFields) checkField("readings." + std::string(field.key), text);
}

}  // namespace

void throwAngles(std::string_view bytes) {
  const std::string text(bytes);
  checkAngle(text);
  checkNumber(text);
  checkFields(text);
  for (const AngleUnit unit : {AngleUnit::Degrees, AngleUnit::Gon, AngleUnit::Dms})
    checkAngle(withUnit(text, unit));
  if (const Result<int> whole = parseWhole(text))
    require(std::abs(*whole) <= 999999999, "a whole number of more than nine digits");
}

}  // namespace alidade::fuzz
