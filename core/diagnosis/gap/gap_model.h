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

// A model of the session with its fit: the session's own model, or one with added causes.

struct GapModel {
  std::shared_ptr<const Measurement> measurement;  ///< the arcs that can be fitted
  std::vector<Circle> starts;
  JointFitOptions options;
  std::shared_ptr<const JointFit> fit;  ///< fit of `measurement`; shared because a million rows are too large
                                        ///< to copy
  double noise = 1;  ///< ratio of estimated to stated noise; the σ of `measurement` and `fit` include it

  /// Repeats the fit after a change.
  void refit();
};

/// Returns `measurement` with the σ of all readings multiplied by `factor`. The σ of the pointing zeros are
/// multiplied only if `zerosAreReadings`.
Measurement withNoise(Measurement measurement, double factor);

/// Returns the session's own model with its fit. Both arguments must outlive the model. Fails if no arc can
/// be fitted.
Result<GapModel, NoModel> modelOf(const Measurement& measurement, const SessionFit& fit);
Result<GapModel, NoModel> modelOf(const Measurement&& measurement, const SessionFit& fit) = delete;
Result<GapModel, NoModel> modelOf(const Measurement& measurement, const SessionFit&& fit) = delete;
/// Fits the measurement and stores the fit in the model.
Result<GapModel, NoModel> modelOf(const Measurement& measurement);

/// Returns `own` with a rigid guideway that turns about the axis (`JointFitOptions::isClosed`). The new model
/// also uses what the positions have in common. Absent without both positions, or if the fit fails.
std::optional<GapModel> closedModelOf(const GapModel& own);

/// Returns the session's own model with the causes that `closed` adds, fixed at their sizes in `closed`. The
/// result has the residuals and closures after these causes. Returns `closed` itself if it is not closed.
GapModel openedModelOf(const GapModel& closed, const GapModel& own);

/// Returns ∂Δd/∂reading of the model's fit, mm per σ of the reading, in the order of `JointFit::readings`.
Eigen::VectorXd influencePerSigma(const GapModel& model);

ReadingRef readingRef(const Leftover& leftover, Eigen::Index reading);

}  // namespace alidade
