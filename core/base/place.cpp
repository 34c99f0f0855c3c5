#include "core/base/place.h"

namespace alidade {

std::string Place::path() const {
  std::string path;
  if (position) {
    path = "positions[" + std::to_string(*position) + "]";
    if (reading) path += ".readings[" + std::to_string(*reading) + "]";
    if (!field.empty()) path += ".";
  }
  return path + field;
}

}  // namespace alidade
