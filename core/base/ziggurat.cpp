#include "core/base/ziggurat.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace alidade {

namespace {

constexpr std::size_t layers = 256;
constexpr double edge = 3.6541528853610088;        // start of the tail
constexpr double layerArea = 4.92867323399141e-3;  // under exp(−x²/2), including the tail's layer

struct Layers {
  std::array<double, layers + 1> width;   ///< of each, from the tail's up; the last is 0
  std::array<double, layers + 1> height;  ///< exp(−x²/2) at the width

  Layers() {
    const auto density = [](double x) { return std::exp(-x * x / 2); };
    width[0] = layerArea / density(edge);  // the tail as an equivalent box
    width[1] = edge;
    for (std::size_t i = 2; i < layers; ++i)
      width[i] = std::sqrt(-2 * std::log(layerArea / width[i - 1] + density(width[i - 1])));
    width[layers] = 0;
    for (std::size_t i = 0; i <= layers; ++i) height[i] = density(width[i]);
  }
};

const Layers table;

/// A value beyond the edge (Marsaglia, 1964).
double drawTail(RandomSource& random) {
  while (true) {
    const double beyond = -std::log(random.uniform()) / edge;
    if (-2 * std::log(random.uniform()) > beyond * beyond) return edge + beyond;
  }
}

inline double draw(RandomSource& random) {
  while (true) {
    const std::uint64_t bits = random.bits();
    const std::size_t layer = bits % layers;
    const double share = (static_cast<double>(bits >> 11) + 0.5) * 0x1p-52 - 1;  // in (−1, 1)
    const double x = share * table.width[layer];
    if (std::abs(x) < table.width[layer + 1]) return x;
    if (layer == 0) return std::copysign(drawTail(random), share);
    const double height =
        table.height[layer] + random.uniform() * (table.height[layer + 1] - table.height[layer]);
    if (height < std::exp(-x * x / 2)) return x;
  }
}

}  // namespace

double zigguratNormal(RandomSource& random) {
  return draw(random);
}

void fillWithNormals(RandomSource& random, std::span<double> values) {
  RandomSource own = random;
  for (double& value : values) value = draw(own);
  random = own;
}

}  // namespace alidade
