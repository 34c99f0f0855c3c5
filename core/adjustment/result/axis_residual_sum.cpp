#include "core/adjustment/result/axis_residual_sum.h"

#include <algorithm>
#include <cmath>

namespace alidade {

AxisResidualSum residualSumAt(const SessionFit& fit, int axisDeg) {
  AxisResidualSum sum;
  double squares = 0;
  std::size_t first = 0, arcs = 0;
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    const ArcFit& arc = fit.arcs[i];
    if (arc.axisDeg != axisDeg) continue;
    if (arcs++ == 0) first = i;
    sum.sightings += arc.residuals.size();
    sum.degreesOfFreedom += arc.degreesOfFreedom;
    sum.chiSquare += arc.chiSquare;
    squares += arc.residualRms * arc.residualRms * static_cast<double>(arc.residuals.size());
  }
  if (sum.sightings > 0) sum.residualRms = std::sqrt(squares / static_cast<double>(sum.sightings));
  if (arcs < 2) return sum;
  // The arcs' own degrees of freedom do not yet subtract the unknowns that several arcs share.
  for (std::size_t i = 0; i < fit.joint.unknowns.size(); ++i) {
    const Unknown& unknown = fit.joint.unknowns[i];
    if (unknown.isOfAxis() && unknown.arc == first && std::isinf(fit.joint.priorSigmas[i]))
      --sum.degreesOfFreedom;
  }
  return sum;
}

}  // namespace alidade
