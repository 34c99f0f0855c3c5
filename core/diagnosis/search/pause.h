#pragma once

#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// In the pause between two positions, the guideway is turned and the zero is sighted. The pause is counted in
// rows; without times it is unknown. A drift continues during the pause: it turns the later position and its
// zeros by its rate times the pause. Without a pause in the model, a large drift needs a jump in addition.
//
// The pause is therefore estimated together with a drift, as the value with the largest likelihood × prior.
// The prior has a mean of four rows. In the model with the drift the pause keeps its prior uncertainty, as a
// jump of the orientation before the next zero (`addPause`).

/// Returns the pause in rows that fits best with the most likely explanation. Absent if this explanation has
/// no drift, the rows have times, no zeros were sighted, there is one position only, or the session is long.
std::optional<double> likeliestPause(const Inquiry& inquiry);

/// Adds the prior of the pause after the first position for each drift of the explanation.
void addPause(JointFitOptions& model, const Measurement& measurement, const Explanation& explanation,
              const Candidates& candidates);

}  // namespace alidade
