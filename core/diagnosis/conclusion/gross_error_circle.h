#pragma once

#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

// Which circle was misread. A sighting alone in its visit, in one face and without slider, gives one
// condition for two circles. An error of either circle can cause the same misfit, but its correction puts the
// slider at a different place on the arc. If the other places are evenly spaced, the misread circle is the
// one whose correction restores the spacing (visit_check.h).

/// Returns `grossErrors`, each at the other circle of its row if that is likelier. `model` excludes these
/// readings.
std::vector<ReadingDeviation> withLikelierCircles(const GapModel& model,
                                                  std::vector<ReadingDeviation> grossErrors);

}  // namespace alidade
