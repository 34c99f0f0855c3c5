#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

// What was known beforehand, held against the readings, in words. Effects are called as `name` has it.

/// "collimation: known as 3.2 ± 0.5″; these readings say 3.0 ± 0.4″": 1σ each, without a full
/// stop.
std::string textOf(const KnownCheck& check, const CauseNamer& name = byId);

/// Of every effect of which what was known holds no longer, and of every cause that but for what is known
/// could be another, one sentence after the other; empty where there is none.
std::string staleSentence(const Diagnosis& diagnosis, const CauseNamer& name = byId);

}  // namespace alidade
