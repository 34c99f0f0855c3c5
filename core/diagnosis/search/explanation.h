#pragma once

#include <Eigen/Core>
#include <stop_token>
#include <vector>

#include "core/diagnosis/candidates/candidates.h"

namespace alidade {

// The search for the components that explain a leftover. In the linear model with normal weights the evidence
// of a set has a closed form. Sets grow by one component at a time, and the best few are kept. Each is
// evaluated with the stated noise (± 10 %) and with larger noise.
//
// Source: MacKay, "Bayesian interpolation", Neural Computation 4 (1992); the marginal likelihood of the
// Bayesian linear model.

/// One component of an explanation with its weights.
struct Part {
  std::size_t component = 0;  ///< index into the candidates
  double width = 1;           ///< most likely prior width, in plausible sizes
  Eigen::VectorXd weights;    ///< in plausible sizes
  double logGain = 0;         ///< natural logarithm of its Bayes factor, given the previous parts

  /// Whether the evidence for the part exceeds rounding errors.
  bool isSupported() const;
};

struct Explanation {
  std::vector<Part> parts;
  bool noisy = false;           ///< with noise larger than stated
  double noise = 1;             ///< most likely scale of the noise
  double logPosteriorOdds = 0;  ///< natural logarithm of prior odds × Bayes factor, against the empty set
  double logBayesFactor = 0;    ///< natural logarithm of the Bayes factor, against the empty set
  double chiSquare = 0;         ///< χ² after the explanation, with the stated σ
  double chance = 0;            ///< probability among the explanations found, 0…1
  bool shaped = false;          ///< contains a pattern without a named cause

  bool has(std::size_t component) const;
};

/// Whether `larger` contains all components of `smaller`, and larger noise if `smaller` has it.
bool isPartOf(const Explanation& smaller, const Explanation& larger);
/// Whether both have the same components in any order and the same kind of noise.
bool areAlike(const Explanation& a, const Explanation& b);

struct SearchOptions {
  PriorOdds odds = {};
  bool noise = true;  ///< noise may be larger than stated
  std::size_t beam = 6;
  std::size_t mostParts = 3;        ///< of a set, unless all parts are gross errors
  std::size_t mostGrossErrors = 6;  ///< of a set that has no other parts
  std::stop_token stop = {};        ///< on a stop request the search ends with its results so far
};

/// Returns the explanations, the best first. They include the empty set for each kind of noise.
std::vector<Explanation> explain(const Leftover& leftover, const Candidates& candidates,
                                 const SearchOptions& options = {});

/// The natural logarithm of the evidence integrated over the scale of the noise, larger than stated or about
/// the stated one, relative to the evidence at the scale `reference`; and the likeliest scale.
struct NoiseEvidence {
  double log = 0, likeliest = 1;
};
/// `chiSquare` (stated σ) is what an explanation leaves, with these degrees of freedom.
NoiseEvidence evidenceOfNoise(bool isLarger, double chiSquare, double degreesOfFreedom, double reference);

/// Fits one component alone with the stated noise: its evidence without prior, and its weights. `residual` is
/// the leftover; `index` is the index of the component.
Part fitAlone(const SharedProducts& residual, const Component& component, std::size_t index);

}  // namespace alidade
