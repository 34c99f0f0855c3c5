#include "core/base/problem.h"

namespace alidade {

std::string Problem::text() const {
  const std::string path = where.path();
  return path.empty() ? what : path + ": " + what;
}

}  // namespace alidade
