#include "core/series/shared_causes/session_sums.h"

#include <algorithm>
#include <cmath>

namespace alidade {

using Eigen::Index, Eigen::VectorXd;

EffectMatrix blockOf(const SharedColumns& columns, const std::vector<double>& products,
                     const EffectColumns& a, const EffectColumns& b) {
  EffectMatrix block(static_cast<Index>(a.count), static_cast<Index>(b.count));
  for (std::size_t i = 0; i < a.count; ++i)
    for (std::size_t j = 0; j < b.count; ++j)
      block(static_cast<Index>(i), static_cast<Index>(j)) =
          products[columns.productAt(a.first + i, b.first + j)];
  return block;
}

double SessionSums::variance(std::size_t explanation) const {
  return std::pow(std::max(m_noise, m_evidence->explanations[explanation].noise), 2);
}

EffectMatrix SessionSums::normal(std::size_t explanation, const EffectColumns& a,
                                 const EffectColumns& b) const {
  EffectMatrix block = plainNormal(a, b);
  const SessionExplanation& own = m_evidence->explanations[explanation];
  const std::size_t columns = m_evidence->columns->count();
  for (std::size_t d = 0; d < own.directions; ++d) {
    const Eigen::Map<const VectorXd> ofA(&own.taken[d * columns + a.first], block.rows()),
        ofB(&own.taken[d * columns + b.first], block.cols());
    block.noalias() -= ofA.lazyProduct(ofB.transpose());
  }
  return block / variance(explanation);
}

EffectVector SessionSums::right(std::size_t explanation, const EffectColumns& effect) const {
  const std::vector<double>& right = m_evidence->explanations[explanation].right;
  return Eigen::Map<const VectorXd>(&right[effect.first], static_cast<Index>(effect.count)) /
         variance(explanation);
}

double SessionSums::logOdds(std::size_t explanation) const {
  const SessionExplanation& own = m_evidence->explanations[explanation];
  if (m_noise == 1) return own.logOdds;
  if (own.noisy && own.noise <= m_noise) return own.logOdds - 1e3;  // `m_noise` includes its larger noise
  // The reduction of χ² by the explanation is scaled to `m_noise`. An explanation of larger noise loses the
  // part of its gain that `m_noise` already provides.
  const double gained = (m_evidence->chiSquare - own.chiSquare) / 2;
  if (!own.noisy) return own.logOdds - gained + gained / variance(explanation);
  return own.logOdds - m_evidence->chiSquare / 2 * (1 - 1 / (m_noise * m_noise)) +
         m_evidence->degreesOfFreedom * std::log(m_noise);
}

EffectMatrix SessionSums::plainNormal(const EffectColumns& a, const EffectColumns& b) const {
  return blockOf(*m_evidence->columns, m_evidence->normal, a, b);
}

}  // namespace alidade
