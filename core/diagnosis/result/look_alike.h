#pragma once

#include <string>

namespace alidade {

/// An effect that would leave nearly the same.
struct LookAlike {
  std::string effect;     ///< id
  double cosine = 0;      ///< of the angle between the traces, 0…1
  double difference = 0;  ///< distance of the traces, σ of the readings
};

}  // namespace alidade
