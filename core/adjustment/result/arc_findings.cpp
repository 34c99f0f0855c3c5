#include "core/adjustment/result/arc_findings.h"

#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/adjustment/arc/arc_checks.h"
#include "core/base/first_index.h"
#include "core/base/statistics.h"

namespace alidade {

using namespace arc_finding;

namespace {

/// A chance this small is taken for a sign that the stated noise is wrong.
constexpr double surprise = 0.001;
constexpr double poorRadiusUncertainty = 0.01;
constexpr double farFromNominal = 0.05;

void add(std::vector<FitFinding>& findings, const ArcFit& fit, Severity severity, What what) {
  findings.push_back({severity, Place{.position = fit.position, .reading = {}, .field = "readings"},
                      ArcFinding{fit.axisDeg, std::move(what), fit.time}});
}

void judgeRedundancyAndNoise(std::vector<FitFinding>& findings, const ArcFit& fit) {
  if (fit.degreesOfFreedom <= 0) return add(findings, fit, Severity::Warning, NothingChecks{});
  const std::optional<double> upper = chiSquareUpperTail(fit.chiSquare, fit.degreesOfFreedom);
  if (!upper) return;
  if (*upper < surprise)
    add(findings, fit, Severity::Warning, ScattersMore{fit.reducedChiSquare(), fit.degreesOfFreedom});
  else if (1 - *upper < surprise)
    add(findings, fit, Severity::Note, ScattersLess{fit.reducedChiSquare(), fit.degreesOfFreedom});
}

void judgeRadius(std::vector<FitFinding>& findings, const Measurement& measurement, const ArcFit& fit) {
  const double sigma = fit.radiusSigma();
  if (sigma > poorRadiusUncertainty * fit.circle.radius)
    add(findings, fit, Severity::Warning, RadiusPoorlyKnown{arcSpan(fit), sigma});
  const double difference = fit.circle.radius - measurement.nominalRadius;
  if (std::abs(difference) > farFromNominal * measurement.nominalRadius + 3 * sigma)
    add(findings, fit, Severity::Warning, RadiusFarFromNominal{fit.circle.radius, measurement.nominalRadius});
}

/// What two rows that repeat each other have in common.
struct Circles {
  int face = 0;
  double a = 0, e = 0;  // rad

  auto operator<=>(const Circles&) const = default;
};

struct HashOfCircles {
  std::size_t operator()(const Circles& key) const {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); };  // no −0
    const std::uint64_t sum = bits(key.a) * 3 + bits(key.e) * 5 + static_cast<std::uint64_t>(key.face);
    const std::uint64_t product = (sum ^ sum >> 29U) * 0x9e3779b97f4a7c15U;
    return static_cast<std::size_t>(product ^ product >> 32U);
  }
};

void judgeRepeats(std::vector<FitFinding>& findings, const ArcMeasurement& arc, const ArcFit& fit) {
  FirstIndex<Circles, HashOfCircles> firsts(arc.sightings.size());
  ReadingsRepeat repeat;
  for (std::size_t i = 0; i < arc.sightings.size(); ++i) {
    const Sighting& row = arc.sightings[i];
    const std::size_t first = firsts.put({row.face, row.a.radians(), row.e.radians()}, i);
    if (first != i) repeat.rows.emplace_back(arc.sightings[first].row, row.row);
  }
  if (!repeat.rows.empty()) add(findings, fit, Severity::Warning, std::move(repeat));
}

}  // namespace

std::vector<FitFinding> arcFindings(const Measurement& measurement, const ArcMeasurement& arc,
                                    const ArcFit& fit) {
  std::vector<FitFinding> findings;
  if (!fit.converged()) add(findings, fit, Severity::Warning, NotSettled{fit.iterations});
  judgeRedundancyAndNoise(findings, fit);
  judgeRadius(findings, measurement, fit);
  judgeRepeats(findings, arc, fit);
  return findings;
}

}  // namespace alidade
