#include "core/adjustment/result/session_findings.h"

#include <cmath>
#include <optional>
#include <utility>

#include "core/adjustment/arc/arc_checks.h"
#include "core/adjustment/result/row_repeats.h"
#include "core/base/statistics.h"

namespace alidade {

using namespace arc_finding;

namespace {

constexpr double poorRadiusUncertainty = 0.01;
constexpr double farFromNominal = 0.05;
constexpr double leastTested = 1;  // with less redundancy, χ² of shared unknowns is not distributed as χ²

void add(std::vector<FitFinding>& findings, const ArcFit& fit, Severity severity, What what) {
  findings.push_back({severity, Place{.position = fit.position, .reading = {}, .field = "readings"},
                      ArcFinding{fit.axisDeg, std::move(what), fit.repeat}});
}

void judgeRedundancyAndNoise(std::vector<FitFinding>& findings, const ArcFit& fit) {
  if (fit.degreesOfFreedom <= 0) return add(findings, fit, Severity::Warning, NothingChecks{});
  if (fit.degreesOfFreedom < leastTested) return;
  const std::optional<double> upper = chiSquareUpperTail(fit.chiSquare, fit.degreesOfFreedom);
  if (!upper) return;
  if (*upper < improbable)
    add(findings, fit, Severity::Warning, ScattersMore{fit.reducedChiSquare(), fit.degreesOfFreedom});
  else if (1 - *upper < improbable)
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

}  // namespace

std::vector<FitFinding> arcFindings(const Measurement& measurement, const ArcMeasurement& arc,
                                    const ArcFit& fit) {
  std::vector<FitFinding> findings;
  if (!fit.converged()) add(findings, fit, Severity::Warning, NotConverged{fit.iterations});
  judgeRedundancyAndNoise(findings, fit);
  judgeRadius(findings, measurement, fit);
  if (ReadingsRepeat repeat{repeatedRows(measurement, arc, fit)}; !repeat.rows.empty())
    add(findings, fit, Severity::Warning, std::move(repeat));
  return findings;
}

}  // namespace alidade
