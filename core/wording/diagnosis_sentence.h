#pragma once

#include <functional>
#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// Returns the name of a cause from its identifier.
using CauseNamer = std::function<std::string(const std::string& id)>;

/// The argument of the pattern in a gap without a cause: "vertical readings with azimuth".
std::string patternName(const GapShape& shape);

/// Names a cause by its identifier, as in files and on the console.
std::string byId(const std::string& id);

/// The verdict in whole sentences; `name` gives the causes' names within a sentence.
std::string sentenceOf(const Diagnosis& diagnosis, const CauseNamer& name = byId);

}  // namespace alidade
