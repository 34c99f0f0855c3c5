#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/diagnosis/result/diagnosis_fault.h"
#include "core/diagnosis/result/look_alike.h"
#include "core/session/measurement.h"

namespace alidade {

// The visibility of an effect in noise-free readings that contain it, and its look-alikes. The readings
// contain the effect in its exact size and sign, without linearisation.

struct GapModel;

struct Visibility {
  double sigma = 0;  ///< length of the trace: √χ² of the leftover, stated σ
  /// Look-alikes of the effect in these readings: closer than `clearlyDifferent` σ.
  std::vector<LookAlike> lookAlikes;
  double nearest = 0;  ///< smallest distance to the trace of any other effect, look-alike or not, σ
};

/// The trace includes the closures between both positions, if the session has both. `noiseless` contains the
/// effect `held` only. Look-alikes are other catalogue effects, and a jump between a zero and the first
/// visit. Fails if no arc can be fitted.
Result<Visibility, NoModel> visibilityOf(const Measurement& noiseless, const std::string& held);
/// The same in the residuals of `model`, whose readings contain the effect `held` only.
Visibility visibilityIn(const GapModel& model, const std::string& held);

}  // namespace alidade
