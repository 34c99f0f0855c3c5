#pragma once

#include <string>

namespace alidade {

/// An effect with nearly the same trace.
struct LookAlike {
  std::string effect;     ///< identifier
  double cosine = 0;      ///< cosine of the angle between the traces, 0…1
  double difference = 0;  ///< distance of the traces, σ of the readings
};

}  // namespace alidade
