#pragma once

#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// The pause between two positions, in which the guideway is turned and the zero sighted. It lasts some rows;
// without times their number is unknown. A drift continues meanwhile and turns the later position and its
// zeros by its rate times the pause. Without a pause in the model, a large drift would need a jump, too.
//
// The pause is therefore estimated with a drift: the value with the smallest misfit, with a prior of some
// rows. In the model with the drift it keeps its prior uncertainty, as a jump of the orientation before the
// next zero (`addPause`).

/// Returns the pause in rows that fits best with the most likely explanation. Absent if that explanation
/// has no drift, or if the rows have times.
std::optional<double> likeliestPause(const Inquiry& inquiry);

/// Adds the prior of the pause after the first position for each drift of the explanation.
void addPause(JointFitOptions& model, const Measurement& measurement, const Explanation& explanation,
              const Candidates& candidates);

}  // namespace alidade
