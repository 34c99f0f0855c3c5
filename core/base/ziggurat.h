#pragma once

#include <span>

#include "core/base/random_source.h"

namespace alidade {

/// A normal number, mean 0 and standard deviation 1, in a fifth of the time of `RandomSource::normal`, for
/// draws by the million. The ziggurat of Marsaglia and Tsang ("The ziggurat method for generating random
/// variables", 2000) with 256 layers, layer and place from different bits of one number (Doornik, 2005):
/// exact, including tails. Takes one number of the source; in one per cent of cases, more.
double zigguratNormal(RandomSource& random);
/// Fills all of `values` in sequence: the state of the source then stays in registers.
void fillWithNormals(RandomSource& random, std::span<double> values);

}  // namespace alidade
