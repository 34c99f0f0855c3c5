#pragma once

#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// Shares of a gap by groups of readings, by sources of error, and by closures.

/// Shares of the leftover's sum of squares by position, circle, face, round, sector of the slider and quarter
/// of the session, each in ascending order. Only the excess over the noise counts, or the plain sum of
/// squares if there is no excess. `fit` gives the arc angle of each row.
std::vector<GapShare> sharesOfReadings(const Leftover& leftover, const Measurement& measurement,
                                       const JointFit& fit);

/// Shares of the gap by the source of its cause: "guideway", "instrument", "time", "readings", and "noise"
/// for the unexplained rest. Each explanation counts with its probability. Without both positions, guideway
/// and instrument form one share: "guideway or instrument".
std::vector<GapShare> sharesOfFrames(const Inquiry& inquiry);

/// Shares of χ² beyond the stated noise: of the "readings" in the model with separate positions, and of each
/// closure between positions ("radius", "centre", "repeat", "zeros"). Empty without closures.
std::vector<GapShare> sharesOfClosures(const GapModel& own);

}  // namespace alidade
