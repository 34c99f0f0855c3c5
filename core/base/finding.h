#pragma once

#include <string>

#include "core/base/place.h"

namespace alidade {

enum class Severity {
  Note,     ///< worth knowing; the result stands
  Warning,  ///< the result stands, but should not be trusted before this is looked at
  Error,    ///< there is no result because of this
};

/// What the data say about themselves: an arc too short to fix a radius, readings that scatter more than
/// stated. For people: whole sentences.
struct Finding {
  Severity severity = Severity::Note;
  std::string text;         ///< what was found
  std::string remedy = {};  ///< what to do about it; may be empty
  Place where = {};

  bool operator==(const Finding&) const = default;
};

}  // namespace alidade
