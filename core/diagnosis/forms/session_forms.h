#pragma once

#include <stop_token>

#include "core/diagnosis/forms/find_forms.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

/// The forms that remain with the certain causes and every effect of the catalogue (prior widths `scales`):
/// up to three, the most evident first. Their odds against no form are at least 20 : 1, and they beat the
/// generic patterns; otherwise there are none. `certain`: causes without a pattern. Empty for a session with
/// very many rows.
FoundForms formsBeyond(const Inquiry& inquiry, const Explanation& certain, const EffectScales& scales,
                       const DiagnosisOptions& options, const std::stop_token& stop);

}  // namespace alidade
