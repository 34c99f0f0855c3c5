#pragma once

#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// Where a gap lies.

/// By position, circle, face, round, sector of the slider and quarter of the session, in the order of their
/// values: the leftover's sum of squares beyond what noise leaves there; where nothing is beyond, the plain
/// sum of squares. `fit`: tells where on the arc each row was sighted.
std::vector<GapShare> sharesOfReadings(const Leftover& leftover, const Measurement& measurement,
                                       const JointFit& fit);

/// By frame: what the explanations take up, each as often as it is likely, by what the cause belongs to:
/// "guideway", "instrument", "time", "readings"; what none takes up is "noise". One position alone does not
/// tell the first two apart: they are one share, "guideway or instrument".
std::vector<GapShare> sharesOfFrames(const Inquiry& inquiry);

/// By closure: of χ² beyond what noise leaves, with the noise as stated, what the "readings" leave over in
/// the model with the positions apart, and each closure of theirs ("radius", "centre"). Empty where there is
/// none.
std::vector<GapShare> sharesOfClosures(const GapModel& own);

}  // namespace alidade
