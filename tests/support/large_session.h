#pragma once

#include <algorithm>
#include <cstddef>

#include "core/simulation/simulate.h"

namespace alidade::test {

/// A valid session of at least `rows` rows and at most 34 more, half of them in each position: the usual 17
/// points, read round after round.
inline Session largeSession(std::size_t rows) {
  Protocol protocol;
  protocol.rounds = static_cast<int>((rows + 33) / 34);
  Truth truth = drawTruth(1);
  truth.verticalCircle = VerticalCircle::Zenith;
  return *simulate(protocol, truth, 1);
}

}  // namespace alidade::test
