#include "core/diagnosis/dependence.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "core/base/square.h"
#include "core/diagnosis/diagnose.h"

namespace alidade {

namespace {

/// A row and the first-order effect of its exclusion.
struct Influence {
  std::size_t arc = 0, sighting = 0;  ///< indices in the measurement
  double shift = 0;                   ///< change of Δd, mm
  double chiSquare = 0;               ///< change of χ²
};

/// Number of rows in each visit of an arc.
using RowsOfVisits = std::map<std::pair<std::size_t, std::uint32_t>, int>;

std::vector<Influence> influencesOf(const Measurement& measurement, const SessionFit& fit) {
  constexpr double leastChecked = 0.05;
  struct Sum {
    double shift = 0, chiSquare = 0, redundancy = 0;
    int readings = 0;
    std::uint32_t visit = 0;
  };
  std::map<std::pair<std::size_t, std::size_t>, Sum> sums;
  for (const AdjustedReading& reading : fit.joint.readings) {
    Sum& sum = sums[{reading.arc, reading.sighting}];
    sum.shift -= reading.perReading * reading.residual;
    sum.chiSquare += square(reading.residual / reading.sigma);
    sum.redundancy += reading.redundancy;
    sum.visit = reading.visit;
    ++sum.readings;
  }
  RowsOfVisits rows;
  for (const auto& [at, sum] : sums) ++rows[{at.first, sum.visit}];
  std::vector<Influence> influences;
  for (const auto& [at, sum] : sums) {
    const auto position = fit.arcs[at.first].position;
    const auto arc = std::ranges::find(measurement.arcs, position, &ArcMeasurement::position);
    const int conditions = sum.readings - (rows[{at.first, sum.visit}] == 1 ? 1 : 0);
    const double checked = std::max(sum.redundancy / std::max(conditions, 1), leastChecked);
    influences.push_back({static_cast<std::size_t>(arc - measurement.arcs.begin()), at.second,
                          sum.shift / checked, sum.chiSquare / checked});
  }
  return influences;
}

Dependence dependenceOn(const Measurement& measurement, const Influence& row, Verdict without, bool isExact) {
  const ArcMeasurement& arc = measurement.arcs[row.arc];
  const Sighting& sighting = arc.sightings[row.sighting];
  return {arc.position,   sighting.row,  arc.axisDeg, arc.repeat, sighting.round,
          sighting.point, sighting.face, without,     isExact};
}

/// Returns the verdict after a change of Δd alone by `shift`, mm.
Verdict shifted(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                double shift) {
  const auto decided = [&](const auto& length) {
    return decide(length.value + shift, length.expanded, *measurement.tolerance);
  };
  const Verdict modelled = decided(*fit.intersection);
  if (!diagnosis) return modelled;
  if (!diagnosis->measured) return Verdict::Undecided;
  return decided(diagnosis->measured->estimate) == modelled ? modelled : Verdict::Undecided;
}

/// The verdict without a row; undecided if the remaining rows allow no decision.
Verdict verdictWithout(Measurement measurement, const Influence& row, bool withDiagnosis) {
  std::vector<Sighting>& sightings = measurement.arcs[row.arc].sightings;
  sightings.erase(sightings.begin() + static_cast<std::ptrdiff_t>(row.sighting));
  const SessionFit fit = fitSession(measurement);
  std::optional<Diagnosis> diagnosis;
  if (withDiagnosis)
    if (auto found = diagnose(measurement, fit, {.forVerdict = true})) diagnosis = *std::move(found);
  const auto decision = decideVerdict(measurement, fit, diagnosis ? &*diagnosis : nullptr);
  return decision && diagnosis.has_value() == withDiagnosis ? decision->verdict : Verdict::Undecided;
}

/// Returns the rows to exclude: half of them change Δd most, the other half contributes most to χ².
std::vector<Influence> mostInfluential(std::vector<Influence> rows) {
  const auto take = [&](std::size_t first, auto size) {
    const auto from = rows.begin() + static_cast<std::ptrdiff_t>(std::min(first, rows.size()));
    std::ranges::sort(from, rows.end(), std::greater{}, size);
  };
  take(0, [](const Influence& row) { return std::abs(row.shift); });
  take(mostLeftOut / 2, [](const Influence& row) { return row.chiSquare; });
  rows.resize(std::min(rows.size(), mostLeftOut));
  return rows;
}

}  // namespace

std::vector<Dependence> dependencesOf(const Measurement& measurement, const SessionFit& fit,
                                      const Diagnosis* diagnosis, const AcceptanceDecision& decision,
                                      const std::stop_token& stop) {
  using enum AcceptanceDecision::Obstacle;
  if (decision.obstacle == Lengths || decision.obstacle == Coverage) return {};
  std::vector<Influence> rows = influencesOf(measurement, fit);
  const bool isExact = rows.size() <= mostRowsForLeavingOut;
  if (isExact) rows = mostInfluential(std::move(rows));
  const Verdict linear = shifted(measurement, fit, diagnosis, 0);
  std::vector<Dependence> dependences;
  for (const Influence& row : rows) {
    if (stop.stop_requested()) break;
    Verdict without = decision.verdict;
    if (isExact)
      without = verdictWithout(measurement, row, diagnosis != nullptr);
    else if (linear == decision.verdict)
      without = shifted(measurement, fit, diagnosis, row.shift);
    if (without != decision.verdict) dependences.push_back(dependenceOn(measurement, row, without, isExact));
  }
  std::ranges::sort(dependences, {}, [](const Dependence& d) { return std::pair(d.position, d.row); });
  return dependences;
}

std::vector<Dependence> dependencesOf(const Measurement& measurement, const SessionFit& fit,
                                      const Diagnosis* diagnosis, const std::stop_token& stop) {
  const auto decision = decideAcceptance(measurement, fit, diagnosis);
  return decision ? dependencesOf(measurement, fit, diagnosis, *decision, stop) : std::vector<Dependence>();
}

}  // namespace alidade
