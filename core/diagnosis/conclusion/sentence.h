#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// The verdict in one or two sentences that a metrologist would say.
std::string sentenceFor(const Diagnosis& diagnosis);

}  // namespace alidade
