#pragma once

#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

// Decides which circle was misread. A sighting alone in its visit, in one face and without slider, gives one
// condition for two circles. An error of either circle can cause the same residual, but its correction puts
// the slider at a different place on the arc. If the other visits are evenly spaced, the misread circle is
// the one whose correction restores the spacing (visit_check.h).

/// Returns `grossErrors`. A gross error is moved to the other circle of its row if that circle is likelier.
/// `model` excludes the readings with gross errors.
std::vector<ReadingDeviation> withLikelierCircles(const GapModel& model,
                                                  std::vector<ReadingDeviation> grossErrors);

}  // namespace alidade
