#pragma once

#include <functional>
#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// What a cause is called, by its id.
using CauseNamer = std::function<std::string(const std::string& id)>;

/// What a gap without a cause follows: "vertical readings with azimuth".
std::string patternName(const GapShape& shape);

/// A cause by its id, as files and the console have it.
std::string byId(const std::string& id);

/// The verdict in whole sentences; causes are called as `name` has it, as within a sentence.
std::string sentenceOf(const Diagnosis& diagnosis, const CauseNamer& name = byId);

}  // namespace alidade
