#pragma once

#include <string>

#include "core/base/problem.h"

namespace alidade {

enum class Severity {
  Note,     ///< worth knowing; the result is valid
  Warning,  ///< check this before trusting the result
  Error,    ///< the reason why there is no result
};

/// A finding on the data in whole sentences, such as an arc too short to determine a radius, or readings that
/// scatter more than stated.
struct Finding {
  Severity severity = Severity::Note;
  std::string text;         ///< what was found
  std::string remedy = {};  ///< what to do about it; may be empty
  Place where = {};

  bool operator==(const Finding&) const = default;
};

}  // namespace alidade
