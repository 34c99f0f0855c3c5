#include "core/wording/beyond.h"

namespace alidade {

std::string textOf(Beyond beyond) {
  switch (beyond) {
    case Beyond::Nothing:
      break;
    case Beyond::Pattern:
      return "with what the pattern may move it by";
    case Beyond::LookAlikes:
      return "averaged over what looks alike";
    case Beyond::Others:
      return "averaged over what else may be";
  }
  return "";
}

}  // namespace alidade
