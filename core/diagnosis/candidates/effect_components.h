#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/diagnosis/candidates/component.h"

namespace alidade {

/// An effect of the catalogue or of the user.
class EffectComponent final : public Component {
 public:
  /// `gram` is the Gram matrix of the visible columns.
  EffectComponent(const Effect& effect, Eigen::MatrixXd gram);
  /// Makes the effect bent by its visible second derivatives, in columns 11, 12 and 22.
  void bend(const Leftover& leftover, Eigen::MatrixXd secondDerivatives);

  /// `sigmas` are the known standard uncertainties of the parameters, in plausible sizes.
  void setKnown(Eigen::VectorXd sigmas) { m_known = std::move(sigmas); }

  const Effect& effect() const { return *m_effect; }

  std::string_view id() const override { return m_effect->id; }
  ErrorSource source() const override { return m_effect->source; }
  /// A bent effect counts as linear until its second derivatives are set.
  Response response() const override { return m_response; }
  const std::vector<Width>& widths() const override;
  bool isEffect() const override { return true; }
  bool isKnown() const override { return m_known.size() > 0; }
  Eigen::VectorXd usualSizes() const override { return isKnown() ? m_known : Component::usualSizes(); }
  Eigen::Map<const Eigen::MatrixXd> gram() const override {
    return {m_gram.data(), m_gram.rows(), m_gram.cols()};
  }
  Eigen::Index weights() const override { return static_cast<Eigen::Index>(m_effect->parameters.size()); }
  Eigen::MatrixXd wholeColumns(const Leftover& leftover) const override;
  Eigen::MatrixXd visibleColumns(const Leftover& leftover) const override;
  void fillProducts(const SharedProducts& with, Eigen::Ref<Eigen::VectorXd> own) const override;
  Eigen::VectorXd signature(const Leftover& leftover, const Eigen::VectorXd& weights) const override;
  void addTo(JointFitOptions& model, const Leftover& leftover, const Eigen::VectorXd& weights,
             double width) const override;
  std::vector<CauseParameter> parameters(const GapModel& after) const override;

 private:
  const Effect* m_effect;
  Response m_response;
  Eigen::MatrixXd m_gram;
  Eigen::MatrixXd m_secondDerivatives;  ///< visible; empty unless the effect is bent
  Eigen::VectorXd m_known;              ///< empty unless the size is known
};

/// Prior widths for effects from much smaller to much larger than their plausible size.
const std::vector<Width>& effectWidths();

/// Returns the sought effects of catalogue and user except those in `leftOut`; bent effects count as linear.
std::vector<EffectComponent> effectComponents(const Leftover& leftover,
                                              const std::vector<std::string>& leftOut,
                                              const Measurement& measurement = {});
/// Returns the sought effects of catalogue and user except those in `leftOut`. Bent effects have their second
/// derivatives; effects whose known size is in the model are marked. `leftover` belongs to `model`.
std::vector<EffectComponent> effectsBeyond(const GapModel& model, const Leftover& leftover,
                                           const std::vector<std::string>& leftOut);

}  // namespace alidade
