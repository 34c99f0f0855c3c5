#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/diagnosis/session_evidence.h"

namespace alidade {

/// Of one effect, or two: there are many, so none of them takes room on the heap.
inline constexpr int mostColumns = 12;
using EffectMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, mostColumns, mostColumns>;
using EffectVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, mostColumns, 1>;

/// The normal equations of one session under one account of what it holds by itself, in variances of its
/// noise. Made for one effect, or for two, at a time: those of all effects together are many.
class SessionSums {
 public:
  explicit SessionSums(const SessionEvidence& evidence) : m_evidence(&evidence) {}

  const SessionEvidence& evidence() const { return *m_evidence; }
  std::size_t accounts() const { return m_evidence->accounts.size(); }
  const OwnAccount& account(std::size_t index) const { return m_evidence->accounts[index]; }

  /// Its noise is larger than stated by a factor whatever the account.
  void scaleNoise(double factor) { m_noise = factor; }
  double noise() const { return m_noise; }

  EffectMatrix normal(std::size_t account, const EffectColumns& a, const EffectColumns& b) const;
  EffectVector right(std::size_t account, const EffectColumns& effect) const;
  /// ln of what the account is believed with, against nothing with the noise as it is.
  double logOdds(std::size_t account) const;
  /// CᵀC of two effects, without any account and with the noise stated.
  EffectMatrix plainNormal(const EffectColumns& a, const EffectColumns& b) const;

 private:
  const SessionEvidence* m_evidence;
  double m_noise = 1;

  double variance(std::size_t account) const;
};

/// A block of the inner products that are kept (`productAt`).
EffectMatrix blockOf(const std::vector<double>& products, const EffectColumns& a, const EffectColumns& b);

}  // namespace alidade
