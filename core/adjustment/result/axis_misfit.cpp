#include "core/adjustment/result/axis_misfit.h"

#include <algorithm>
#include <cmath>

namespace alidade {

AxisMisfit misfitAt(const SessionFit& fit, int axisDeg) {
  AxisMisfit misfit;
  double squares = 0;
  std::size_t first = 0, arcs = 0;
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    const ArcFit& arc = fit.arcs[i];
    if (arc.axisDeg != axisDeg) continue;
    if (arcs++ == 0) first = i;
    misfit.sightings += arc.residuals.size();
    misfit.degreesOfFreedom += arc.degreesOfFreedom;
    misfit.chiSquare += arc.chiSquare;
    squares += arc.residualRms * arc.residualRms * static_cast<double>(arc.residuals.size());
  }
  if (misfit.sightings > 0) misfit.residualRms = std::sqrt(squares / static_cast<double>(misfit.sightings));
  if (arcs < 2) return misfit;
  // The arcs' own degrees of freedom do not yet subtract the unknowns that several arcs share.
  for (std::size_t i = 0; i < fit.joint.unknowns.size(); ++i) {
    const Unknown& unknown = fit.joint.unknowns[i];
    if (unknown.isOfAxis() && unknown.arc == first && std::isinf(fit.joint.priorSigmas[i]))
      --misfit.degreesOfFreedom;
  }
  return misfit;
}

}  // namespace alidade
