#pragma once

#include <map>
#include <vector>

#include "core/adjustment/result/intersection.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// How well a term is known beforehand, and the variance of Δd that comes of it, mm².
struct TermShare {
  double priorSigma = 0, variance = 0;
};

/// One account of the readings: Δd with every effect besides the answer, and what its variance is made of.
struct FittedAccount {
  IntersectionEstimate estimate;
  EffectScales scales;
  std::map<ErrorTerm, TermShare> terms;
  std::vector<BudgetEntry> others;  ///< the same source may come twice
  NoiseScale noise;
};

/// The shares of an averaged estimate: those of one account, and what the average has beyond that.
std::vector<UncertaintyShare> budgetOf(const FittedAccount& account, const Measurement& measurement,
                                       const IntersectionEstimate& averaged);

}  // namespace alidade
