#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/diagnosis/session_evidence.h"

namespace alidade {

/// The largest number of columns of one effect. The matrices are numerous: a fixed limit avoids the heap.
inline constexpr int mostColumns = 12;
using EffectMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, mostColumns, mostColumns>;
using EffectVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, mostColumns, 1>;

/// The normal equations of one session under one of its own explanations, divided by the variance of its
/// noise. They are computed for one or two effects at a time: for all effects together they are too large.
class SessionSums {
 public:
  explicit SessionSums(const SessionEvidence& evidence) : m_evidence(&evidence) {}

  const SessionEvidence& evidence() const { return *m_evidence; }
  std::size_t explanations() const { return m_evidence->explanations.size(); }
  const SessionExplanation& explanation(std::size_t index) const { return m_evidence->explanations[index]; }

  /// Multiplies the stated noise by a factor, under every explanation.
  void scaleNoise(double factor) { m_noise = factor; }
  double noise() const { return m_noise; }

  EffectMatrix normal(std::size_t explanation, const EffectColumns& a, const EffectColumns& b) const;
  EffectVector right(std::size_t explanation, const EffectColumns& effect) const;
  /// Log of the explanation's prior odds times its evidence, against no explanation and unchanged noise.
  double logOdds(std::size_t explanation) const;
  /// CᵀC of two effects, without an explanation and at the stated noise.
  EffectMatrix plainNormal(const EffectColumns& a, const EffectColumns& b) const;

 private:
  const SessionEvidence* m_evidence;
  double m_noise = 1;

  double variance(std::size_t explanation) const;
};

/// A block of the stored inner products (`productAt`).
EffectMatrix blockOf(const SharedColumns& columns, const std::vector<double>& products,
                     const EffectColumns& a, const EffectColumns& b);

}  // namespace alidade
