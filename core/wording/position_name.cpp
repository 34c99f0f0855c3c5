#include "core/wording/position_name.h"

#include "core/base/phrase.h"

namespace alidade {

std::string positionName(int axisDeg, int repeat) {
  if (repeat < 2) return std::to_string(axisDeg) + "°";
  return repeat == 2 ? Phrase::of("%1° again", axisDeg) : Phrase::of("%1° again (%2)", axisDeg, repeat);
}

}  // namespace alidade
