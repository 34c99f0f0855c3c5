#include "core/adjustment/result/arc_summary.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace alidade {

namespace {

/// The number of estimated unknowns that the arcs at the axis of arc `first` share.
int sharedUnknowns(const JointFit& joint, std::size_t first) {
  int count = 0;
  for (std::size_t i = 0; i < joint.unknowns.size(); ++i)
    if (joint.unknowns[i].isOfAxis() && joint.unknowns[i].arc == first && std::isinf(joint.priorSigmas[i]))
      ++count;
  return count;
}

void add(ArcSummary& sum, const ArcFit& arc) {
  const double before = sum.sightings, more = static_cast<double>(arc.residuals.size());
  if (before + more > 0)
    sum.residualRms =
        std::sqrt((sum.residualRms * sum.residualRms * before + arc.residualRms * arc.residualRms * more) /
                  (before + more));
  sum.arcs.push_back(&arc);
  sum.sightings += static_cast<int>(arc.residuals.size());
  sum.degreesOfFreedom += arc.degreesOfFreedom;
  sum.chiSquare += arc.chiSquare;
}

std::optional<ArcSummary> summaryAt(const SessionFit& fit, int axisDeg) {
  std::optional<ArcSummary> summary;
  std::size_t first = 0;
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    if (fit.arcs[i].axisDeg != axisDeg) continue;
    if (summary) {
      add(*summary, fit.arcs[i]);
    } else {
      first = i;
      summary = summaryOf(fit.arcs[i], fit.sigmas[i]);
    }
  }
  // The degrees of freedom of arcs that share unknowns do not yet subtract these.
  if (summary && summary->arcs.size() > 1) summary->degreesOfFreedom -= sharedUnknowns(fit.joint, first);
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
