#include "core/base/problem.h"

namespace alidade {

std::string Problem::text() const {
  const std::string path = where.path();
  return path.empty() ? what : path + ": " + what;
}

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
