#pragma once

#include <optional>
#include <string>
#include <variant>

#include "core/adjustment/result/fit_finding.h"

namespace alidade {

// Why there is no answer; `core/wording/diagnosis_fault.h` says it.

/// No arc could be fitted.
struct NoModel {
  std::optional<FitFinding> why = {};  ///< an Error; absent where there are no readings
};

/// It was asked to leave out what cannot be diagnosed.
struct UnknownCause {
  std::string id;
};

struct Stopped {};

using DiagnosisFault = std::variant<NoModel, UnknownCause, Stopped>;

}  // namespace alidade
