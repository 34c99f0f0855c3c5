#include "core/diagnosis/candidates/gross_error_components.h"

#include <cmath>

#include "core/adjustment/joint/sighted_zeros.h"
#include "core/effects/cause_ids.h"
#include "core/session/zero_mean.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

const std::vector<Width>& grossErrorWidths() {
  static const std::vector<Width> widths = evenly({8, 30, 120, 1000});
  return widths;
}

std::string_view GrossErrorComponent::id() const {
  return grossErrorId;
}

const std::vector<Width>& GrossErrorComponent::widths() const {
  return grossErrorWidths();
}

MatrixXd GrossErrorComponent::wholeColumns(const Leftover& leftover) const {
  return VectorXd::Unit(leftover.readings(), m_reading);
}

double GrossErrorComponent::signatureLength(const VectorXd& weights) const {
  return std::abs(weights[0]) * std::sqrt(m_redundancy);
}

void GrossErrorComponent::addTo(JointFitOptions& model, const Leftover& leftover, const VectorXd&,
                                double) const {
  model.without.push_back(readingRef(leftover, m_reading));
}

std::vector<GrossErrorComponent> grossErrorComponents(const Leftover& leftover,
                                                      const Measurement& measurement) {
  const auto isSought = [&](const LinearReading& reading) {
    if (!reading.isZero) return true;
    if (reading.arc >= measurement.arcs.size()) return false;
    return isCheckedZero(measurement, reading.arc,
                         indexOfZero(measurement.arcs[reading.arc], reading.sighting));
  };
  std::vector<GrossErrorComponent> components;
  components.reserve(static_cast<std::size_t>(leftover.readings()));
  for (Index i = 0; i < leftover.readings(); ++i)
    components.emplace_back(i, isSought(leftover.reading(i)) ? leftover.redundancy(i) : 0);
  return components;
}

}  // namespace alidade
