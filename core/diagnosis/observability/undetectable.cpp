#include "core/diagnosis/observability/undetectable.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/square.h"
#include "core/diagnosis/candidates/jump_components.h"
#include "core/diagnosis/result/thresholds.h"

namespace alidade {

using Eigen::VectorXd;

bool Detectability::isUndetectable() const {
  return influence > thresholds.negligibleInfluence && visible < thresholds.clearlyDifferent;
}

Detectability detectabilityOf(const Component& component, const SharedProducts& perReading) {
  const VectorXd sizes = component.usualSizes();
  const VectorXd influence = component.wholeProducts(perReading).cwiseProduct(sizes);
  Detectability detectability{component.id(), influence.normalized().cwiseProduct(sizes), influence.norm(),
                              0};
  if (detectability.influence == 0) return detectability;
  detectability.visible = component.signatureLength(detectability.weights);
  if (component.response() != Response::Bent) return detectability;  // either sign leaves the same trace
  const double opposite = component.signatureLength(-detectability.weights);
  if (opposite < detectability.visible) {
    detectability.weights = -detectability.weights;
    detectability.visible = opposite;
  }
  return detectability;
}

std::vector<Detectability> undetectableEffects(const Leftover& leftover, const Candidates& candidates,
                                               const VectorXd& perReading) {
  std::vector<Detectability> undetectable;
  const SharedProducts influence(leftover, perReading);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Component& component = candidates[i];
    const bool isNamed = component.isEffect() || component.isJump();
    if (!isNamed || component.response() == Response::AllOrNothing) continue;
    Detectability detectability = detectabilityOf(component, influence);
    if (!detectability.isUndetectable()) continue;
    const auto same = std::ranges::find(undetectable, detectability.effect, &Detectability::effect);
    if (same == undetectable.end())
      undetectable.push_back(std::move(detectability));
    else if (same->influence < detectability.influence)
      *same = std::move(detectability);
  }
  std::ranges::sort(undetectable, std::greater{}, &Detectability::influence);
  return undetectable;
}

namespace {

/// Returns the arc of a jump, and whether the jump lies between the zero and the first sighting of this arc.
std::pair<std::size_t, bool> placeOf(const Component& jump, const Measurement& measurement) {
  if (const auto arc = jump.wrongZeroArc()) return {*arc, true};
  const std::size_t first = jump.jumpMoment()->first;
  std::size_t arc = 0;
  const auto endsBefore = [&](const ArcMeasurement& one) {
    return std::ranges::max(one.sightings, {}, &Sighting::order).order < first;
  };
  while (arc + 1 < measurement.arcs.size() && endsBefore(measurement.arcs[arc])) ++arc;
  return {arc, false};
}

/// Adds a jump at another moment: probabilities add up, and each width gets the root mean square of the
/// influences.
void addMoment(UndetectableJump& jumps, double odds, double influence) {
  const std::vector<Width>& widths = jumpWidths();
  jumps.moves.resize(widths.size());
  for (std::size_t w = 0; w < widths.size(); ++w) {
    NormalPart& move = jumps.moves[w];
    const double chance = odds * std::exp(widths[w].logChance), all = move.share + chance;
    move.sigma =
        std::sqrt((move.share * square(move.sigma) + chance * square(widths[w].sigma * influence)) / all);
    move.share = all;
  }
  jumps.influence = std::max(jumps.influence, influence);
}

}  // namespace

std::vector<UndetectableJump> undetectableJumps(const Leftover& leftover, const Candidates& candidates,
                                                const VectorXd& perReading, const Measurement& measurement) {
  const SharedProducts influence(leftover, perReading);
  std::map<std::pair<std::size_t, bool>, UndetectableJump> byPlace;
  for (const Candidates::Group& group : candidates.groups()) {
    if (!candidates[group.first].isJump()) continue;
    for (std::size_t i = group.first; i < group.first + group.count; ++i) {
      const Detectability detectability = detectabilityOf(candidates[i], influence);
      if (!detectability.isUndetectable()) continue;
      const auto place = placeOf(candidates[i], measurement);
      const ArcMeasurement& arc = measurement.arcs[place.first];
      const auto [entry, isNew] = byPlace.try_emplace(
          place, UndetectableJump{.axisDeg = arc.axisDeg, .repeat = arc.repeat, .isAfterZero = place.second});
      addMoment(entry->second, std::exp(group.logPrior), detectability.influence);
    }
  }
  std::vector<UndetectableJump> jumps;
  for (auto& [place, jump] : byPlace) jumps.push_back(std::move(jump));
  return jumps;
}

}  // namespace alidade
