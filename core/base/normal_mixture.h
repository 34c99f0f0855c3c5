#pragma once

#include <vector>

namespace alidade {

// The distribution of a quantity with several possible explanations, each with its own normal distribution.
// Two distant parts give two peaks. The 95 % interval reaches the smaller peak if its share is at least 5 %;
// mean ± 2 σ reaches it only from a share of 20 % on.
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

/// Mean and σ of a non-empty mixture: σ² is the mean of the variances plus the variance of the means.
MeanAndSigma momentsOf(const std::vector<NormalPart>& mixture);

/// The h for which centre ± h contains `coverage`, in (0, 1), of a non-empty mixture; relative error 1e-6.
double halfWidth(const std::vector<NormalPart>& mixture, double centre, double coverage);

/// Joins parts whose mean and σ lie in the same interval of width `grain` into one part with their moments.
/// The distribution hardly changes, but its evaluation is faster. `grain` > 0, in the means' unit.
std::vector<NormalPart> joined(const std::vector<NormalPart>& mixture, double grain);

}  // namespace alidade
