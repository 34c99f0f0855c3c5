#pragma once

#include <Eigen/Core>
#include <stop_token>
#include <vector>

#include "core/diagnosis/candidates/candidates.h"

namespace alidade {

// Which components explain a leftover. In the linear model with normal weights the evidence of a set of
// components has a closed form; sets are grown one component at a time, the best few are kept, and each is
// weighed with the noise as stated (give or take a tenth) and with noise larger than stated.
//
// Source: MacKay, "Bayesian interpolation", Neural Computation 4 (1992); the marginal likelihood of the
// Bayesian linear model.

/// One component of an explanation with the weights it takes.
struct Part {
  std::size_t component = 0;  ///< index into the candidates
  double width = 1;           ///< most likely, in plausible sizes
  Eigen::VectorXd weights;    ///< in plausible sizes
  double logGain = 0;         ///< evidence it adds to the parts before it, natural

  /// The readings speak for it, by more than rounding.
  bool isSupported() const;
};

struct Explanation {
  std::vector<Part> parts;
  bool noisy = false;           ///< with noise larger than stated
  double noise = 1;             ///< most likely scale of the noise
  double logPosteriorOdds = 0;  ///< prior and evidence, against nothing at all, natural
  double logBayesFactor = 0;    ///< without the prior
  double chiSquare = 0;         ///< of what is left, stated σ
  double chance = 0;            ///< 0…1, that it is the right one of those found
  bool shaped = false;          ///< holds a pattern of no named cause

  bool has(std::size_t component) const;
};

/// The larger one has all components of the smaller, and larger noise where that has.
bool isPartOf(const Explanation& smaller, const Explanation& larger);
/// The same components, in whatever order, under noise of the same kind.
bool areAlike(const Explanation& a, const Explanation& b);

struct SearchOptions {
  PriorOdds odds = {};
  bool noise = true;  ///< noise may be larger than stated
  std::size_t beam = 6;
  std::size_t mostParts = 3;  ///< but more where they are gross errors
  std::size_t mostGrossErrors = 6;
  std::stop_token stop = {};  ///< asked to stop, the search ends with what it has found
};

/// The best first. Always holds the explanation of no part without and with larger noise.
std::vector<Explanation> explain(const Leftover& leftover, const Candidates& candidates,
                                 const SearchOptions& options = {});

/// What is believed of the noise of an explanation, summed up where χ² (stated σ) is left of its readings
/// with so many degrees of freedom: the natural logarithm of the evidence against that of its likeliest
/// noise, or the stated one where it is not noisy.
double logEvidenceOfNoise(const Explanation& explanation, double chiSquare, double degreesOfFreedom);

/// One component alone, noise as stated: its evidence, without its prior, and the weights it then has.
/// `residual`: what is left over. `index` is that of the component.
Part fitAlone(const SharedProducts& residual, const Component& component, std::size_t index);

}  // namespace alidade
