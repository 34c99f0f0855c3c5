#pragma once

#include <vector>

#include "core/diagnosis/component.h"
#include "core/diagnosis/diagnosis.h"
#include "core/diagnosis/explanation.h"

namespace alidade {

// Where a gap lies. For the .cpp files of this room only.

/// By position, circle, face, round, sector of the slider and quarter of the session: the leftover's sum of
/// squares beyond what noise leaves there; where nothing is beyond, the plain sum of squares.
std::vector<GapShare> sharesOfReadings(const Leftover& leftover, const Measurement& measurement,
                                       const JointFit& fit);

/// By frame: what the explanations take up, each as often as it is likely, by what the cause stays with:
/// "guideway", "instrument", "time", "readings"; what none takes up is "noise".
std::vector<GapShare> sharesOfFrames(const Leftover& leftover, const std::vector<Component>& candidates,
                                     const std::vector<Explanation>& explanations);

}  // namespace alidade
