#include "core/series/instrument_check/check_record.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "core/base/number_text.h"
#include "core/base/square.h"
#include "core/series/instrument_check/check_findings.h"

namespace alidade {

namespace {

struct Estimate {
  double value, u;
};

/// The mean over targets: where these differ by more than scatter, by their own differences.
Estimate collimationOf(const StationCheck& station) {
  if (station.tilt) return {station.tilt->collimation, station.tilt->uCollimation};
  if (station.eccentricity) return {station.eccentricity->collimation, station.eccentricity->uCollimation};
  if (!(station.targetsDifferP < levelOfTests)) return {station.collimation.value, station.collimation.u};
  double squares = 0;
  for (const TargetMean& target : station.perTarget)
    squares += square(target.collimation - station.collimation.value);
  const auto count = static_cast<double>(station.perTarget.size());
  return {station.collimation.value, std::sqrt(squares / (count - 1) / count)};
}

std::optional<Estimate> weighted(const std::vector<Estimate>& estimates) {
  double weights = 0, sum = 0, misfit = 0;
  std::size_t count = 0;
  for (const auto& [value, u] : estimates)
    if (u > 0) {
      weights += 1 / square(u);
      sum += value / square(u);
      ++count;
    }
  if (count == 0) return std::nullopt;
  const double mean = sum / weights;
  for (const auto& [value, u] : estimates)
    if (u > 0) misfit += square((value - mean) / u);
  const double spread = count > 1 ? std::sqrt(misfit / static_cast<double>(count - 1)) : 1;
  return Estimate{mean, std::max(1.0, spread) / std::sqrt(weights)};
}

/// To a thousandth of a second.
double rounded(double value) {
  constexpr double perArcsecond = 1000;
  return std::round(value * perArcsecond) / perArcsecond;
}

}  // namespace

InstrumentRecord checkedRecord(const InstrumentCheck& check, const std::string& name,
                               const std::string& serial, const std::string& date) {
  InstrumentRecord record{.name = name, .serial = serial, .date = date};
  const auto sigmaText = [](const CheckScatter& scatter) {
    return scatter.s() > 0 ? shortestText(rounded(scatter.s() * std::numbers::sqrt2)) : std::string();
  };
  record.sigmaHorizontalArcsec = sigmaText(check.direction);
  record.sigmaVerticalArcsec = sigmaText(check.vertical);
  std::vector<Estimate> collimations, indices, tilts;
  for (const StationCheck& station : check.stations) {
    if (station.pairs() == 0) continue;
    collimations.push_back(collimationOf(station));
    indices.push_back({station.index.value, station.index.u});
    if (showsTilt(station)) tilts.push_back({station.tilt->other, station.tilt->uOther});
  }
  const auto addKnown = [&](const char* effect, const std::vector<Estimate>& estimates) {
    constexpr double leastU = 1e-3;
    if (const auto known = weighted(estimates))
      record.known.push_back({.effect = effect,
                              .value = shortestText(rounded(known->value)),
                              .sigma = shortestText(std::max(rounded(known->u), leastU)),
                              .unit = "arcsec",
                              .from = "instrument check after ISO 17123-3",
                              .date = date});
  };
  addKnown("collimation", collimations);
  addKnown("trunnion_tilt", tilts);
  addKnown("vertical_index", indices);
  return record;
}

}  // namespace alidade
