#include "core/adjustment/result/input_reliability.h"

#include <algorithm>
#include <cmath>

#include "core/base/square.h"

namespace alidade {

namespace {

bool isInput(const Unknown& unknown) {
  return unknown.isPointingZero() || unknown.kind == Unknown::Kind::Radius;
}

/// ∂Δd/∂unknowns; zeros without an intersection.
std::vector<double> weightsOfIntersection(const SessionFit& fit) {
  if (!fit.intersection) return std::vector<double>(fit.joint.unknowns.size());
  const auto indexAt = [&](int axisDeg) {
    return static_cast<std::size_t>(fit.arcAt(axisDeg) - fit.arcs.data());
  };
  return intersectionWeights(fit.joint, indexAt(0), indexAt(180));
}

/// Sign of an entered value relative to its unknown in the equations (`ArcPose`): the unknown of a zero is
/// its error, by which the readings are reduced, and zenith circles count downwards.
double perEntered(const Unknown& unknown, const Measurement& measurement) {
  if (!unknown.isPointingZero()) return 1;
  const bool countsUp =
      unknown.kind == Unknown::Kind::VerticalZero && measurement.verticalCircle == VerticalCircle::Elevation;
  return countsUp ? 1 : -1;
}

}  // namespace

std::vector<InputReliability> reliabilityOfInputs(const Measurement& measurement, const SessionFit& fit) {
  const JointFit& joint = fit.joint;
  const std::vector<double> weights = weightsOfIntersection(fit);
  std::vector<InputReliability> inputs;
  for (std::size_t i = 0; i < joint.unknowns.size(); ++i) {
    const Unknown& unknown = joint.unknowns[i];
    if (!isInput(unknown) || std::isinf(joint.priorSigmas[i])) continue;
    const double variance = square(joint.priorSigmas[i]);
    inputs.push_back(
        {unknown, joint.priorSigmas[i], std::clamp(1 - joint.cofactor(i, i) / variance, 0.0, 1.0),
         covarianceWith(joint.cofactor, weights, i) / variance * perEntered(unknown, measurement)});
  }
  for (std::size_t c = 0; c < joint.considered.size(); ++c)
    inputs.push_back({joint.considered[c], joint.consideredSigmas[c], 0,
                      ratePerConsidered(joint, weights, c) * perEntered(joint.considered[c], measurement)});
  return inputs;
}

}  // namespace alidade
