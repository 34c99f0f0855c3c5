#pragma once

#include <initializer_list>
#include <vector>

namespace alidade {

/// A possible prior width of the weights of a component, with its probability.
struct Width {
  double sigma;      ///< in plausible sizes
  double logChance;  ///< natural logarithm of the probability
};

/// Returns equally probable widths.
std::vector<Width> evenly(std::initializer_list<double> sigmas);
/// Adds a far larger width with a probability of 1 %.
std::vector<Width> andFarWider(std::vector<Width> widths, double sigma);

}  // namespace alidade
