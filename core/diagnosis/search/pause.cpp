#include "core/diagnosis/search/pause.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/square.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/search/explained_model.h"

namespace alidade {

namespace {

constexpr double usualPause = 4, pauseKnownTo = 4;  // rows

struct Drift {
  ErrorTerm step;   ///< the jump term of the drift's circle
  double size = 0;  ///< change of the circle over the session, rad
};

std::vector<Drift> driftsOf(const Explanation& explanation, const Candidates& candidates) {
  std::vector<Drift> drifts;
  for (const Part& part : explanation.parts) {
    const Effect* effect = effectById(candidates[part.component].id());
    if (!effect || part.weights.size() == 0) continue;
    const ErrorTerm term = effect->parameters.front().term;
    const double size = part.weights[0] * plausibleSize(effect->parameters.front());
    if (term == ErrorTerm::HorizontalDrift) drifts.push_back({ErrorTerm::HorizontalJump, size});
    if (term == ErrorTerm::VerticalDrift) drifts.push_back({ErrorTerm::VerticalJump, size});
  }
  return drifts;
}

/// Returns −2 ln of likelihood and prior of a given pause; infinite if the fit fails.
double leftWith(const Inquiry& inquiry, const Explanation& explanation, double pause) {
  GapModel own = inquiry.own;
  Measurement paused = *own.measurement;
  paused.pauseRows = pause;
  setMoments(paused);
  own.measurement = std::make_shared<const Measurement>(std::move(paused));
  const std::optional<GapModel> closed = closedModelOf(withKnownSizes(std::move(own)));
  if (!closed) return std::numeric_limits<double>::infinity();
  GapModel model{closed->measurement, closed->starts, closed->options, {}, closed->noise};
  for (const Part& part : explanation.parts) {
    const Component& component = inquiry.of(part);
    component.addTo(model.options, inquiry.leftover, part.weights,
                    component.widthOfFit(part.width, part.weights));
  }
  model.refit();
  if (!model.fit->converged()) return std::numeric_limits<double>::infinity();
  const double noise = explanation.noisy ? explanation.noise : 1;
  return model.fit->chiSquare / square(noise) + 2 * pause / usualPause;
}

}  // namespace

std::optional<double> likeliestPause(const Inquiry& inquiry) {
  constexpr double pauses[] = {0, 2, 4, 6, 9, 13, 20};
  constexpr std::size_t mostRows = 20'000;  // the pause is negligible in longer sessions
  const Measurement& measurement = *inquiry.base.measurement;
  if (!measurement.sightedZeros || measurement.arcs.size() < 2 || measurement.rows > mostRows ||
      hasTimes(measurement))
    return std::nullopt;
  Explanation causes = inquiry.explanations.front();
  if (driftsOf(causes, inquiry.candidates).empty()) return std::nullopt;
  std::erase_if(causes.parts, [&](const Part& part) { return inquiry.of(part).isJump(); });
  double best = 0, least = std::numeric_limits<double>::infinity();
  for (const double pause : pauses)
    if (const double left = leftWith(inquiry, causes, pause); left < least) {
      least = left;
      best = pause;
    }
  return best;
}

void addPause(JointFitOptions& model, const Measurement& measurement, const Explanation& explanation,
              const Candidates& candidates) {
  if (!measurement.sightedZeros || measurement.arcs.size() < 2 || model.jumpBefore || hasTimes(measurement))
    return;
  const std::vector<SightedZero>& zeros = measurement.arcs[1].zeroSightings;
  const auto before = std::ranges::find(zeros, false, &SightedZero::isAfter);
  if (before == zeros.end()) return;
  for (const Drift& drift : driftsOf(explanation, candidates)) {
    const double length = static_cast<double>(measurement.rows) + measurement.pauseRows;
    const double perRow = drift.size / length, step = perRow * (usualPause - measurement.pauseRows);
    model.terms.push_back({drift.step, std::abs(perRow) * pauseKnownTo, step, step});
    model.jumpBefore = before->order;
  }
}

}  // namespace alidade
