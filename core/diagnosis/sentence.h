#pragma once

#include <string>

#include "core/diagnosis/diagnosis.h"

namespace alidade {

/// For the .cpp files of this room only. The verdict in one or two sentences that a metrologist would say.
std::string sentenceFor(const Diagnosis& diagnosis);

}  // namespace alidade
