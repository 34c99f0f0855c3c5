#pragma once

#include <stop_token>

#include "core/diagnosis/forms/find_forms.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

/// Finds up to three forms in the residuals that the certain causes and every effect of the catalogue (prior
/// widths `scales`) leave, the most evident first. Their odds against no form are at least 20 : 1. They are
/// also likelier than the generic patterns, or nearly as likely and leave only noise. `certain` has the
/// causes without a pattern. Empty for a session with very many rows.
FoundForms formsBeyond(const Inquiry& inquiry, const Explanation& certain, const EffectScales& scales,
                       const DiagnosisOptions& options, const std::stop_token& stop);

}  // namespace alidade
