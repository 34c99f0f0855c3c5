#pragma once

#include <vector>

namespace alidade {

// The distribution of a quantity with several possible explanations, each with its own normal distribution.
// Two distant ones give two peaks: the 95 % interval reaches the smaller peak once its share is 5 %, twice
// the standard deviation only once its share is 20 %.
//
// Source: JCGM 101:2008, 7.7, coverage interval from the distribution.

struct NormalPart {
  double share = 0;  ///< > 0; the shares need not add up to 1
  double mean = 0;
  double sigma = 0;  ///< > 0
};

struct MeanAndSigma {
  double mean = 0, sigma = 0;
};

/// Mean and σ of one part or more: σ² is the mean of the variances plus the variance of the means.
MeanAndSigma momentsOf(const std::vector<NormalPart>& mixture);

/// h such that centre ± h contains `coverage`, in (0, 1), for one part or more; to a relative 1e-6.
double halfWidth(const std::vector<NormalPart>& mixture, double centre, double coverage);

/// Joins parts whose means differ by less than `grain`, with similar variances, into one part with their
/// moments. The distribution hardly changes, but evaluates faster. `grain` > 0, in the means' unit.
std::vector<NormalPart> joined(const std::vector<NormalPart>& mixture, double grain);

}  // namespace alidade
