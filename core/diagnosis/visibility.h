#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/diagnosis/result/diagnosis_fault.h"
#include "core/diagnosis/result/look_alike.h"
#include "core/session/measurement.h"

namespace alidade {

// What an effect leaves in readings that are free of noise: how far it shows, and what it looks like. Nothing
// about the size or the sign of the effect is taken from a linear model, since the readings themselves hold
// the effect.

struct Visibility {
  double sigma = 0;  ///< length of the trace: √χ² of what is left over, stated σ
  /// Effects that these readings do not tell apart from the one they hold: closer than `clearlyDifferent` σ.
  std::vector<LookAlike> lookAlikes;
  double nearest = 0;  ///< the least distance to what any other effect leaves, look-alike or not, σ
};

/// With what the two positions must agree on, where both are there. `noiseless` holds the effect `held` and
/// nothing else; look-alikes are the other effects of the catalogue, and a jump between a zero and the first
/// place. Fails where no arc can be fitted.
Result<Visibility, NoModel> visibilityOf(const Measurement& noiseless, const std::string& held);
/// In the residuals of the session's own model alone.
Result<Visibility, NoModel> visibilityInResiduals(const Measurement& noiseless, const std::string& held);

}  // namespace alidade
