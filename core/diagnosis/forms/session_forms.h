#pragma once

#include <stop_token>

#include "core/diagnosis/forms/find_forms.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

/// The forms of what is left beside what is certain, and beside every effect of the catalogue, so many
/// plausible sizes wide: up to three, the plainest first. A form beats nothing by 20 : 1, and the generic
/// patterns; else there is none. `certain`: causes, without a pattern. Empty for a session of very many rows.
FoundForms formsBeyond(const Inquiry& inquiry, const Explanation& certain, const EffectScales& scales,
                       const DiagnosisOptions& options, const std::stop_token& stop);

}  // namespace alidade
