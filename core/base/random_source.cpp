#include "core/base/random_source.h"

#include <algorithm>
#include <cassert>

#include "core/base/statistics.h"

namespace alidade {

namespace {

std::uint64_t splitMix(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

}  // namespace

RandomSource::RandomSource(std::uint64_t seed, std::uint64_t stream) {
  // The stream's number is mixed over all bits first, so that neighbouring seeds and streams do not coincide.
  std::uint64_t state = splitMix(stream) ^ seed;
  for (std::uint64_t& word : m_state) word = splitMix(state);
}

double RandomSource::uniform(double low, double high) {
  return low + (high - low) * uniform();
}

double RandomSource::normal() {
  return normalQuantile(uniform());
}

int RandomSource::whole(int low, int high) {
  assert(low <= high);
  const int count = high - low + 1;
  return low + std::min(count - 1, static_cast<int>(uniform() * count));
}

}  // namespace alidade
