#include "core/base/random_source.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace alidade {

namespace {

using Coefficients = std::array<double, 8>;

/// One of the three ranges of AS 241: a quotient of two polynomials of degree 7, lowest power first.
struct Quotient {
  Coefficients above, below;

  double at(double x) const {
    double numerator = 0, denominator = 0;
    for (std::size_t i = above.size(); i-- > 0;) {
      numerator = numerator * x + above[i];
      denominator = denominator * x + below[i];
    }
    return numerator / denominator;
  }
};

constexpr Quotient centre = {
    {3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3, 1.3731693765509461125e4,
     4.5921953931549871457e4, 6.7265770927008700853e4, 3.3430575583588128105e4, 2.5090809287301226727e3},
    {1.0, 4.2313330701600911252e1, 6.8718700749205790830e2, 5.3941960214247511077e3, 2.1213794301586595867e4,
     3.9307895800092710610e4, 2.8729085735721942674e4, 5.2264952788528545610e3}};

constexpr Quotient tail = {{1.42343711074968357734e0, 4.63033784615654529590e0, 5.76949722146069140550e0,
                            3.64784832476320460504e0, 1.27045825245236838258e0, 2.41780725177450611770e-1,
                            2.27238449892691845833e-2, 7.74545014278341407640e-4},
                           {1.0, 2.05319162663775882187e0, 1.67638483018380384940e0,
                            6.89767334985100004550e-1, 1.48103976427480074590e-1, 1.51986665636164571966e-2,
                            5.47593808499534494600e-4, 1.05075007164441684324e-9}};

constexpr Quotient farTail = {
    {6.65790464350110377720e0, 5.46378491116411436990e0, 1.78482653991729133580e0, 2.96560571828504891230e-1,
     2.65321895265761230930e-2, 1.24266094738807843860e-3, 2.71155556874348757815e-5,
     2.01033439929228813265e-7},
    {1.0, 5.99832206555887937690e-1, 1.36929880922735805310e-1, 1.48753612908506148525e-2,
     7.86869131145613259100e-4, 1.84631831751005468180e-5, 1.42151175831644588870e-7,
     2.04426310338993978564e-15}};

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

double normalQuantile(double probability) {
  assert(probability > 0 && probability < 1);
  const double q = probability - 0.5;
  if (std::abs(q) <= 0.425) return q * centre.at(0.180625 - q * q);
  const double depth = std::sqrt(-std::log(q < 0 ? probability : 1 - probability));
  const double size = depth <= 5 ? tail.at(depth - 1.6) : farTail.at(depth - 5);
  return q < 0 ? -size : size;
}

}  // namespace alidade
