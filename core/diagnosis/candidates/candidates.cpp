#include "core/diagnosis/candidates/candidates.h"

#include <algorithm>

namespace alidade {

bool Candidates::haveGrossErrors() const {
  return std::ranges::any_of(
      m_groups, [&](const Group& group) { return (*this)[group.first].grossErrorAt().has_value(); });
}

void Candidates::fillProducts(const SharedProducts& with, Eigen::Ref<Eigen::VectorXd> all) const {
  Eigen::Index first = 0;
  for (const auto& block : m_blocks) first += block->fillProducts(with, all.tail(all.size() - first));
}

}  // namespace alidade
