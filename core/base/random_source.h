#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace alidade {

/// Random numbers that are the same on every machine and for any distribution of the work over threads: each
/// piece of work has its own stream, identified by a seed and a number. xoshiro256++ (Blackman and Vigna,
/// "Scrambled linear pseudorandom number generators", 2021), seeded through SplitMix64. A normal number is
/// the normal quantile of a uniform one, since std::normal_distribution depends on the library.
class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed, std::uint64_t stream = 0);

  std::uint64_t bits() {
    auto& s = m_state;
    const std::uint64_t result = std::rotl(s[0] + s[3], 23) + s[0];
    const std::uint64_t shifted = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= shifted;
    s[3] = std::rotl(s[3], 45);
    return result;
  }
  /// A random number in (0, 1): a multiple of 2⁻⁵³ plus 2⁻⁵⁴.
  double uniform() { return (static_cast<double>(bits() >> 11) + 0.5) * 0x1p-53; }
  double uniform(double low, double high);  ///< in (low, high)
  double normal();                          ///< mean 0, standard deviation 1
  int whole(int low, int high);             ///< low…high, both included, with equal probability

 private:
  std::array<std::uint64_t, 4> m_state;
};

}  // namespace alidade
