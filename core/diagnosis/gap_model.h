#pragma once

#include <memory>
#include <vector>

#include "core/adjustment/intersection.h"
#include "core/adjustment/joint_fit.h"
#include "core/base/result.h"
#include "core/diagnosis/component.h"
#include "core/diagnosis/explanation.h"

namespace alidade {

// A model of the session and its fit: as the session has it, or with causes added. For the .cpp files of this
// room only.

struct GapModel {
  std::shared_ptr<const Measurement> measurement;  ///< the arcs that can be fitted
  std::vector<Circle> starts;
  JointFitOptions options;
  JointFit fit;
  double noise = 1;  ///< scale of the noise that was found
};

/// The session's own model. Fails where no arc can be fitted, with the reason.
Result<GapModel> modelOf(const Measurement& measurement);

/// `base` with the parts of an explanation added, fitted anew.
GapModel modelWith(const GapModel& base, const Explanation& explanation,
                   const std::vector<Component>& candidates, const Leftover& leftover);

/// ∂Δd/∂reading of the model's fit, mm per σ of the reading, in the order of `JointFit::readings`.
Eigen::VectorXd influencePerSigma(const GapModel& model);

ReadingRef readingRef(const Leftover& leftover, Eigen::Index reading);

}  // namespace alidade
