#pragma once

#include <vector>

#include "core/diagnosis/candidates/component.h"

namespace alidade {

/// A gross error of one reading; the weight is in σ of the reading. The class is small because there is one
/// object for every reading.
class GrossErrorComponent final : public Component {
 public:
  /// `reading` is an index into the leftover's readings.
  GrossErrorComponent(Eigen::Index reading, double redundancy)
      : m_reading(reading), m_redundancy(redundancy) {}

  std::string_view id() const override;
  ErrorSource source() const override { return ErrorSource::Reading; }
  const std::vector<Width>& widths() const override;
  std::optional<Eigen::Index> grossErrorAt() const override { return m_reading; }
  Eigen::Map<const Eigen::MatrixXd> gram() const override {
    return Eigen::Map<const Eigen::MatrixXd>(&m_redundancy, 1, 1);
  }
  Eigen::MatrixXd wholeColumns(const Leftover& leftover) const override;
  void fillProducts(const SharedProducts& with, Eigen::Ref<Eigen::VectorXd> own) const override {
    own[0] = with.vector()[m_reading];
  }
  double signatureLength(const Eigen::VectorXd& weights) const override;
  /// Excludes the reading from the model.
  void addTo(JointFitOptions& model, const Leftover& leftover, const Eigen::VectorXd& weights,
             double width) const override;

 private:
  Eigen::Index m_reading;
  double m_redundancy;
};

const std::vector<Width>& grossErrorWidths();

/// Returns one component for every reading, in order. The component of a zero's reading has redundancy 0 and
/// is never chosen, unless its face was sighted again (`isCheckedZero` of `measurement`): a misread zero that
/// was sighted once acts as a jump of its position.
std::vector<GrossErrorComponent> grossErrorComponents(const Leftover& leftover,
                                                      const Measurement& measurement = {});

}  // namespace alidade
