#pragma once

#include <optional>
#include <string>
#include <variant>

#include "core/adjustment/result/fit_finding.h"

namespace alidade {

// The reason why a diagnosis failed; `core/wording/diagnosis_sentence.h` formulates it.

/// No arc could be fitted.
struct NoModel {
  std::optional<FitFinding> why = {};  ///< a finding of severity Error; absent without readings
};

/// The options exclude an unknown identifier.
struct UnknownCause {
  std::string id;
};

struct Stopped {};

using DiagnosisFault = std::variant<NoModel, UnknownCause, Stopped>;

}  // namespace alidade
