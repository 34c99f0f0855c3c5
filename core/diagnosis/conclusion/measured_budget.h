#pragma once

#include <map>
#include <vector>

#include "core/adjustment/result/intersection.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// Prior uncertainty of a term, and its contribution to the variance of Δd, mm².
struct TermShare {
  double priorSigma = 0, variance = 0;
};

/// One explanation of the readings: Δd with the answer and every effect, and the parts of its variance.
struct FittedExplanation {
  IntersectionEstimate estimate;
  EffectScales scales;
  std::map<ErrorTerm, TermShare> terms;
  std::vector<BudgetEntry> others;  ///< other contributions; a source may occur twice
  NoiseScale noise;
};

/// The shares in the σ of an averaged estimate, the largest first: the shares of one explanation, and the
/// share that the average adds.
std::vector<UncertaintyShare> budgetOf(const FittedExplanation& fitted, const Measurement& measurement,
                                       const IntersectionEstimate& averaged);

}  // namespace alidade
