#include "core/wording/position_name.h"

namespace alidade {

std::string positionName(int axisDeg, int time) {
  std::string name = std::to_string(axisDeg) + "°";
  if (time > 1) name += " again";
  if (time > 2) name += " (" + std::to_string(time) + ")";
  return name;
}

}  // namespace alidade
