#pragma once

#include <string>

#include "core/base/place.h"

namespace alidade {

enum class Severity {
  Note,     ///< worth knowing; the result is valid
  Warning,  ///< check this before trusting the result
  Error,    ///< the reason why there is no result
};

/// A finding on the data: an arc too short to determine a radius, readings that scatter more than stated. For
/// people: whole sentences.
struct Finding {
  Severity severity = Severity::Note;
  std::string text;         ///< what was found
  std::string remedy = {};  ///< what to do about it; may be empty
  Place where = {};

  bool operator==(const Finding&) const = default;
};

}  // namespace alidade
