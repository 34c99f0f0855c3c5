#pragma once

#include "core/series/shared_causes/series_diagnosis.h"

namespace alidade {

/// Offers each form that at least three sessions of a guideway found, or of an instrument if it acts on
/// circles, as an effect of the user's own.
void addOfferedEffects(SeriesDiagnosis& diagnosis);

}  // namespace alidade
