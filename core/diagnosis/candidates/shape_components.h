#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/candidates/component.h"
#include "core/diagnosis/candidates/pattern.h"

namespace alidade {

/// A pattern without a named cause.
class ShapeComponent final : public Component {
 public:
  /// `follows` is static text. `gram` is the Gram matrix of the visible columns.
  ShapeComponent(std::string_view follows, ErrorSource source, Pattern pattern, Eigen::MatrixXd gram);

  std::string_view id() const override { return m_follows; }
  ErrorSource source() const override { return m_source; }
  const std::vector<Width>& widths() const override;
  bool isShape() const override { return true; }
  Eigen::Map<const Eigen::MatrixXd> gram() const override {
    return {m_gram.data(), m_gram.rows(), m_gram.cols()};
  }
  Eigen::MatrixXd wholeColumns(const Leftover& leftover) const override;
  void fillProducts(const SharedProducts& with, Eigen::Ref<Eigen::VectorXd> own) const override;
  Eigen::VectorXd times(const Leftover& leftover, const Eigen::VectorXd& weights) const override;
  /// Does nothing: a pattern is not a term of the model.
  void addTo(JointFitOptions& model, const Leftover& leftover, const Eigen::VectorXd& weights,
             double width) const override;

 private:
  std::string_view m_follows;
  ErrorSource m_source;
  Pattern m_pattern;
  Eigen::MatrixXd m_gram;
};

/// Returns smooth, periodic and stepwise patterns over the guideway, the circles and time. A pattern that an
/// effect of the catalogue produces is excluded, unless `leftOut` contains the effect.
std::vector<ShapeComponent> shapeComponents(const Leftover& leftover, const Measurement& measurement,
                                            const JointFit& fit, const std::vector<std::string>& leftOut);

}  // namespace alidade
