#include "core/series/instrument_check/check_record.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/number_text.h"
#include "core/session/entry.h"

namespace alidade {

namespace {

/// Rounds to 1/`perUnit` of the unit, by default to a thousandth.
double rounded(double value, double perUnit = 1000) {
  return std::round(value * perUnit) / perUnit;
}

/// The offset with its u and its correlation with the collimation, from the fit of the check.
LineOfSight lineOfSightOf(const InstrumentCheck& check) {
  if (!check.lineOfSight) return {};
  constexpr double perMillimetre = 10000, most = 0.9999;
  const TwoCauses& sight = *check.lineOfSight;
  const double u = std::max(rounded(sight.uOther, perMillimetre), 1 / perMillimetre);
  return {.offsetMm = shortestText(rounded(sight.other, perMillimetre)),
          .sigmaMm = shortestText(u),
          .correlation = shortestText(std::clamp(rounded(sight.correlation, perMillimetre), -most, most))};
}

}  // namespace

InstrumentRecord checkedRecord(const InstrumentCheck& check, const CheckIdentity& identity) {
  InstrumentRecord record{.name = identity.name,
                          .serial = identity.serial,
                          .date = identity.measuredOn,
                          .due = identity.due,
                          .verticalCircle = keyOf(identity.circle)};
  const auto sigmaText = [](const CheckScatter& scatter) {
    return scatter.s() > 0 ? shortestText(rounded(scatter.s() * std::numbers::sqrt2)) : std::string();
  };
  record.sigmaHorizontalArcsec = sigmaText(check.direction);
  record.sigmaVerticalArcsec = sigmaText(check.vertical);
  record.lineOfSight = lineOfSightOf(check);
  const auto addKnown = [&](const char* effect, const PairMean& mean) {
    constexpr double leastU = 1e-3;  // below it, the readings repeat exactly and show no scatter
    if (!(mean.u >= leastU)) return;
    record.known.push_back({.effect = effect,
                            .value = shortestText(rounded(mean.value)),
                            .sigma = shortestText(rounded(mean.u)),
                            .unit = "arcsec",
                            .from = std::string(fromInstrumentCheck),
                            .date = identity.measuredOn});
  };
  addKnown("collimation", check.collimation);
  if (check.tilt) addKnown("trunnion_tilt", *check.tilt);
  addKnown("vertical_index", check.index);
  return record;
}

}  // namespace alidade
