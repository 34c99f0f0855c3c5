#pragma once

#include <vector>

#include "core/diagnosis/observability/unseen.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

/// Each further reading that would help, tried out on the model: the same session with the other face, the
/// way back, the slider, a shifted circle, a second stand-off or more of the arc read along. Where the
/// cause has look-alikes: how far they would then be apart; else, how well the most dangerous of the unseen
/// effects would then be seen. And the pointing zero sighted again, where a jump may look like a misread
/// value or be seen in no reading.
std::vector<Advice> adviceFor(const Inquiry& inquiry, const std::vector<Cause>& causes,
                              const std::vector<Detectability>& unseen);

}  // namespace alidade
