#include "core/adjustment/result/arc_summary.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/statistics.h"

namespace alidade {

namespace {

void add(ArcSummary& sum, const ArcFit& arc) {
  const double before = sum.sightings, more = static_cast<double>(arc.residuals.size());
  if (before + more > 0)
    sum.residualRms =
        std::sqrt((sum.residualRms * sum.residualRms * before + arc.residualRms * arc.residualRms * more) /
                  (before + more));
  sum.arcs.push_back(&arc);
  sum.sightings += static_cast<int>(arc.residuals.size());
  sum.degreesOfFreedom = redundancyOf(sum.degreesOfFreedom + arc.degreesOfFreedom);
  sum.chiSquare += arc.chiSquare;
}

std::optional<ArcSummary> summaryAt(const SessionFit& fit, int axisDeg) {
  std::optional<ArcSummary> summary;
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    if (fit.arcs[i].axisDeg != axisDeg) continue;
    if (summary)
      add(*summary, fit.arcs[i]);
    else
      summary = summaryOf(fit.arcs[i], fit.sigmas[i]);
  }
  return summary;
}

}  // namespace

double ArcSummary::reducedChiSquare() const {
  return degreesOfFreedom > 0 ? chiSquare / degreesOfFreedom : std::numeric_limits<double>::quiet_NaN();
}

ArcSummary summaryOf(const ArcFit& arc, const ArcSigma& sigma) {
  return {{&arc},        sigma,          static_cast<int>(arc.residuals.size()), arc.degreesOfFreedom,
          arc.chiSquare, arc.residualRms};
}

std::vector<ArcSummary> summariesByAxis(const SessionFit& fit) {
  std::vector<ArcSummary> summaries;
  for (const int axisDeg : {0, 180})
    if (std::optional<ArcSummary> summary = summaryAt(fit, axisDeg)) summaries.push_back(std::move(*summary));
  return summaries;
}

}  // namespace alidade
