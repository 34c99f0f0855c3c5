#include "core/diagnosis/candidates/misreading_components.h"

#include <cmath>

#include "core/effects/cause_ids.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

const std::vector<Width>& misreadingWidths() {
  static const std::vector<Width> widths = evenly({8, 30, 120, 1000});
  return widths;
}

std::string_view MisreadingComponent::id() const {
  return misreadingId;
}

const std::vector<Width>& MisreadingComponent::widths() const {
  return misreadingWidths();
}

MatrixXd MisreadingComponent::wholeColumns(const Leftover& leftover) const {
  return VectorXd::Unit(leftover.readings(), m_reading);
}

double MisreadingComponent::signatureLength(const VectorXd& weights) const {
  return std::abs(weights[0]) * std::sqrt(m_redundancy);
}

void MisreadingComponent::addTo(JointFitOptions& model, const Leftover& leftover, const VectorXd&,
                                double) const {
  model.without.push_back(readingRef(leftover, m_reading));
}

std::vector<MisreadingComponent> misreadingComponents(const Leftover& leftover) {
  std::vector<MisreadingComponent> components;
  components.reserve(static_cast<std::size_t>(leftover.readings()));
  for (Index i = 0; i < leftover.readings(); ++i) components.emplace_back(i, leftover.redundancy(i));
  return components;
}

}  // namespace alidade
