#pragma once

#include <vector>

#include "core/diagnosis/candidates/component.h"
#include "core/diagnosis/forms/form_search.h"

namespace alidade {

/// Forms as one component: the columns of their amplitudes, then the change of the readings per standard
/// uncertainty of each shape number. No term of the model corresponds to this component.
class FormComponent final : public Component {
 public:
  /// `readings` belong to `leftover`; `forms` have amplitudes, mm or arcseconds.
  FormComponent(const Leftover& leftover, const FormReadings& readings,
                const std::vector<const WeighedForm*>& forms);

  std::string_view id() const override;
  ErrorSource source() const override { return m_source; }
  const std::vector<Width>& widths() const override;
  Eigen::Map<const Eigen::MatrixXd> gram() const override {
    return {m_gram.data(), m_gram.rows(), m_gram.cols()};
  }
  Eigen::MatrixXd wholeColumns(const Leftover&) const override { return m_columns; }
  void addTo(JointFitOptions&, const Leftover&, const Eigen::VectorXd&, double) const override {}
  std::vector<CauseParameter> parameters(const GapModel&) const override { return {}; }

  /// The forms' own amplitudes as weights of the columns; 0 for the shape numbers.
  const Eigen::VectorXd& found() const { return m_found; }

 private:
  ErrorSource m_source;
  Eigen::MatrixXd m_columns;  ///< columns over the readings, before projection
  Eigen::MatrixXd m_gram;
  Eigen::VectorXd m_found;

  void add(const FormReadings& readings, const WeighedForm& form);
};

}  // namespace alidade
