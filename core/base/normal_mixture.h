#pragma once

#include <vector>

namespace alidade {

// What is believed of a quantity when several accounts of it are possible, each with its own normal
// distribution. Two accounts far apart make a distribution of two peaks: its interval at 95 % reaches to the
// farther one as soon as that has 5 %, while twice the standard deviation does so from 20 % on alone.
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

/// Of one part or more: the variances averaged, and the variance of the means.
MeanAndSigma momentsOf(const std::vector<NormalPart>& mixture);

/// h such that centre ± h holds `coverage`, in (0, 1), of one part or more; to 1e-6 of itself.
double halfWidth(const std::vector<NormalPart>& mixture, double centre, double coverage);

/// Parts whose means are less than `grain` apart, and whose variances are as alike, joined in one with their
/// moments: what is believed hardly changes, what it costs to ask does. `grain` > 0, in the means' unit.
std::vector<NormalPart> joined(const std::vector<NormalPart>& mixture, double grain);

}  // namespace alidade
