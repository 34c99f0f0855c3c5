#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

// The comparison of known sizes with the readings, in words.

/// One sentence for each effect whose known size is out of date, and for each cause that only known sizes
/// distinguish from another. Empty without either.
std::string staleSentence(const Diagnosis& diagnosis);

}  // namespace alidade
