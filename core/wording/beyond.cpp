#include "core/wording/beyond.h"

#include "core/base/phrase.h"

namespace alidade {

std::string textOf(Beyond beyond) {
  switch (beyond) {
    case Beyond::Nothing:
      break;
    case Beyond::Pattern:
      return Phrase::of("with the pattern's possible effect");
    case Beyond::LookAlikes:
      return Phrase::of("averaged over the indistinguishable causes");
    case Beyond::Others:
      return Phrase::of("averaged over the possible explanations");
  }
  return "";
}

}  // namespace alidade
