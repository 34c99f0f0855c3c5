#include "core/series/shared_causes/session_sums.h"

#include <algorithm>
#include <cmath>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd blockOf(const std::vector<double>& lowerTriangle, const EffectColumns& a, const EffectColumns& b) {
  MatrixXd block(static_cast<Index>(a.count), static_cast<Index>(b.count));
  for (std::size_t i = 0; i < a.count; ++i)
    for (std::size_t j = 0; j < b.count; ++j) {
      const std::size_t row = std::max(a.first + i, b.first + j), column = std::min(a.first + i, b.first + j);
      block(static_cast<Index>(i), static_cast<Index>(j)) = lowerTriangle[row * (row + 1) / 2 + column];
    }
  return block;
}

double SessionSums::variance(std::size_t account) const {
  return std::pow(std::max(m_noise, m_evidence->accounts[account].noise), 2);
}

MatrixXd SessionSums::normal(std::size_t account, const EffectColumns& a, const EffectColumns& b) const {
  MatrixXd block = plainNormal(a, b);
  const OwnAccount& own = m_evidence->accounts[account];
  const std::size_t columns = columnCount();
  for (std::size_t d = 0; d < own.directions; ++d) {
    const Eigen::Map<const VectorXd> ofA(&own.taken[d * columns + a.first], block.rows()),
        ofB(&own.taken[d * columns + b.first], block.cols());
    block.noalias() -= ofA * ofB.transpose();
  }
  return block / variance(account);
}

VectorXd SessionSums::right(std::size_t account, const EffectColumns& effect) const {
  const std::vector<double>& right = m_evidence->accounts[account].right;
  return Eigen::Map<const VectorXd>(&right[effect.first], static_cast<Index>(effect.count)) /
         variance(account);
}

double SessionSums::logOdds(std::size_t account) const {
  const OwnAccount& own = m_evidence->accounts[account];
  if (m_noise == 1) return own.logOdds;
  if (own.noisy && own.noise <= m_noise) return own.logOdds - 1e3;  // that is how the noise is already
  // What the account takes away counts by the noise.
  const double gained = (m_evidence->chiSquare - own.chiSquare) / 2;
  return own.noisy ? own.logOdds : own.logOdds - gained + gained / variance(account);
}

MatrixXd SessionSums::plainNormal(const EffectColumns& a, const EffectColumns& b) const {
  return blockOf(m_evidence->normal, a, b);
}

}  // namespace alidade
