#pragma once

namespace alidade {

constexpr double square(double value) {
  return value * value;
}

}  // namespace alidade
