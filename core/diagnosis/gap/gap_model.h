#pragma once

#include <memory>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"
#include "core/adjustment/result/session_fit.h"
#include "core/base/result.h"
#include "core/diagnosis/gap/leftover.h"
#include "core/diagnosis/result/diagnosis_fault.h"

namespace alidade {

// A model of the session and its fit: as the session has it, or with causes added.

struct GapModel {
  std::shared_ptr<const Measurement> measurement;  ///< the arcs that can be fitted
  std::vector<Circle> starts;
  JointFitOptions options;
  JointFit fit;
  double noise = 1;  ///< scale of the noise that was found
};

/// The session's own model, by its fit. Fails where no arc could be fitted.
Result<GapModel, NoModel> modelOf(const Measurement& measurement, SessionFit fit);
Result<GapModel, NoModel> modelOf(const Measurement& measurement);

/// ∂Δd/∂reading of the model's fit, mm per σ of the reading, in the order of `JointFit::readings`.
Eigen::VectorXd influencePerSigma(const GapModel& model);

ReadingRef readingRef(const Leftover& leftover, Eigen::Index reading);

}  // namespace alidade
