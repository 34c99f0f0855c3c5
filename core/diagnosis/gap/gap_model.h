#pragma once

#include <memory>
#include <optional>
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
  std::shared_ptr<const JointFit> fit;  ///< of these; of a million rows too large for a copy in every answer
  double noise = 1;  ///< of the stated one that was found; the σ of `measurement` and `fit` are larger by it

  /// Fits anew what was changed.
  void refit();
};

/// `measurement` with its readings scattering more than stated, by a factor; its zeros, too, where they are
/// readings.
Measurement withNoise(Measurement measurement, double factor);

/// The session's own model, by its fit; both have to live as long as the model. Fails where no arc could be
/// fitted.
Result<GapModel, NoModel> modelOf(const Measurement& measurement, const SessionFit& fit);
Result<GapModel, NoModel> modelOf(const Measurement&& measurement, const SessionFit& fit) = delete;
Result<GapModel, NoModel> modelOf(const Measurement& measurement, const SessionFit&& fit) = delete;
/// Fitted here, and kept with the model.
Result<GapModel, NoModel> modelOf(const Measurement& measurement);

/// The same as a rigid guideway turned about the axis has it (`JointFitOptions::isClosed`), so that what the
/// positions must agree on is observed, too. Absent without both positions, or where it cannot be fitted.
std::optional<GapModel> closedModelOf(const GapModel& own);

/// The session's own model with the causes that `closed` has beyond it, held at their sizes there: what they
/// leave in residuals and closures. `closed` itself where it is not closed.
GapModel openedModelOf(const GapModel& closed, const GapModel& own);

/// ∂Δd/∂reading of the model's fit, mm per σ of the reading, in the order of `JointFit::readings`.
Eigen::VectorXd influencePerSigma(const GapModel& model);

ReadingRef readingRef(const Leftover& leftover, Eigen::Index reading);

}  // namespace alidade
