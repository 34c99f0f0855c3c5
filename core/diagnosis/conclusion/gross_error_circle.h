#pragma once

#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

// Which circle was misread. A sighting alone in its visit, in one face and without slider, gives one
// condition for two circles: an error of either can make the same misfit, and puts the slider at another
// place on the arc. Where the other places are evenly spaced the circle is to blame whose correction brings
// the slider back to its own (visit_check.h).

/// `grossErrors` with the circles exchanged where that is likelier. `model` does without them.
std::vector<ReadingDeviation> withLikelierCircles(const GapModel& model,
                                                  std::vector<ReadingDeviation> grossErrors);

}  // namespace alidade
