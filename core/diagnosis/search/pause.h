#pragma once

#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// The pause between two positions, in which the guideway is turned and the zero sighted. The pause is counted
// in rows; without times it is unknown. A drift continues during the pause: the later position and its zeros
// turn by its rate times the pause. Without a pause in the model, a large drift would need a jump, too.
//
// The pause is therefore estimated together with a drift, as the value with the smallest misfit, its prior of
// some rows included. In the model with the drift the pause keeps its prior uncertainty, as a jump of the
// orientation before the next zero (`addPause`).

/// Returns the pause in rows that fits best with the most likely explanation. Absent if that explanation has
/// no drift, if the rows have times, without sighted zeros in two positions, and for very long sessions.
std::optional<double> likeliestPause(const Inquiry& inquiry);

/// Adds the prior of the pause after the first position for each drift of the explanation.
void addPause(JointFitOptions& model, const Measurement& measurement, const Explanation& explanation,
              const Candidates& candidates);

}  // namespace alidade
