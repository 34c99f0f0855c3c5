#pragma once

#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// Between two positions the guideway is turned and the zero sighted, which takes as long as some rows; where
// rows have no times nobody knows how many. A drift goes on meanwhile, so that the later position stands
// turned as a whole by its rate times the pause, and so do its zeros: taken for no pause, a large drift needs
// a knock beside it. So the pause is found along with a drift: the one that leaves least, expected to be of
// some rows. In the model that estimates the drift it is as uncertain as it is beforehand: a step of the
// orientation before the next zero (`addPause`).

/// In rows: of these, with the likeliest explanation in the model, the one that leaves least. Absent where no
/// drift is among its parts, or rows have times.
std::optional<double> likeliestPause(const Inquiry& inquiry);

/// What is known beforehand of the pause behind the first position, for each drift that the explanation has.
void addPause(JointFitOptions& model, const Measurement& measurement, const Explanation& explanation,
              const Candidates& candidates);

}  // namespace alidade
