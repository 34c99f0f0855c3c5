#pragma once

#include "core/series/shared_causes/series_diagnosis.h"

namespace alidade {

/// Offers each form that was found in at least three sessions of one owner, as an effect of the user's own.
/// The owner is the instrument if the form acts on circles, else the guideway.
void addOfferedEffects(SeriesDiagnosis& diagnosis);

}  // namespace alidade
