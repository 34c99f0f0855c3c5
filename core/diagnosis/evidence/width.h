#pragma once

#include <initializer_list>
#include <vector>

namespace alidade {

/// How wide the weights of a component may be, and how likely.
struct Width {
  double sigma;      ///< in plausible sizes
  double logChance;  ///< natural
};

/// Each as likely as the others.
std::vector<Width> evenly(std::initializer_list<double> sigmas);
/// The same, and with a chance of 1 % a far greater one.
std::vector<Width> andFarWider(std::vector<Width> widths, double sigma);

}  // namespace alidade
