#pragma once

#include <vector>

namespace alidade {

// The distribution of a quantity with several possible accounts, each with its own normal distribution. Two
// distant accounts give a distribution with two peaks: its 95 % interval reaches the farther one once that
// has 5 %, while twice the standard deviation does so only from 20 % on.
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

/// Moments of one part or more: the mean variance plus the variance of the means.
MeanAndSigma momentsOf(const std::vector<NormalPart>& mixture);

/// h such that centre ± h contains `coverage`, in (0, 1), for one part or more; to a relative 1e-6.
double halfWidth(const std::vector<NormalPart>& mixture, double centre, double coverage);

/// Joins parts whose means differ by less than `grain`, with similar variances, into one part with their
/// moments. The distribution hardly changes, but evaluates faster. `grain` > 0, in the means' unit.
std::vector<NormalPart> joined(const std::vector<NormalPart>& mixture, double grain);

}  // namespace alidade
