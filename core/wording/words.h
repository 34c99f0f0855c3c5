#pragma once

#include <string>

namespace alidade {

/// A finding, and what to do about it; whole sentences.
struct Words {
  std::string text;
  std::string remedy = {};  ///< may be empty
};

}  // namespace alidade
