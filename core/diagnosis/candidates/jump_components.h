#pragma once

#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "core/diagnosis/candidates/component.h"
#include "core/diagnosis/candidates/jump_columns.h"

namespace alidade {

/// Plausible size (1σ) of a jump of the orientation, rad: 60″.
inline constexpr double plausibleJump = 60.0 / 3600 * std::numbers::pi / 180;

/// A jump of both circles' orientation before a row.
class JumpComponent final : public Component {
 public:
  /// The jump has the moment number `index` of `columns`. `gram` is the Gram matrix of its visible columns.
  JumpComponent(std::shared_ptr<const JumpColumns> columns, std::size_t index, Eigen::Matrix2d gram,
                std::optional<std::size_t> onlyRow);

  JumpMoment moment() const { return m_columns->moments()[m_index]; }

  std::string_view id() const override;
  ErrorSource source() const override { return ErrorSource::Time; }
  const std::vector<Width>& widths() const override;
  bool isJump() const override { return true; }
  std::optional<std::size_t> wrongZeroArc() const override { return m_wrongZeroArc; }
  std::optional<JumpMoment> jumpMoment() const override { return moment(); }
  std::optional<std::size_t> onlyRow() const override { return m_onlyRow; }
  Eigen::Map<const Eigen::MatrixXd> gram() const override { return {m_gram.data(), 2, 2}; }
  Eigen::MatrixXd wholeColumns(const Leftover& leftover) const override;
  void fillProducts(const SharedProducts& with, Eigen::Ref<Eigen::VectorXd> own) const override;
  Eigen::VectorXd wholeProducts(const SharedProducts& with) const override { return products(with); }
  Gain gain(const TurnedColumns& columns, double variance) const override;
  double widthOfFit(double width, const Eigen::VectorXd& weights) const override;
  void addTo(JointFitOptions& model, const Leftover& leftover, const Eigen::VectorXd& weights,
             double width) const override;
  std::vector<CauseParameter> parameters(const GapModel& after) const override;

  void setWrongZeroArc(std::size_t arc) { m_wrongZeroArc = arc; }

 private:
  std::shared_ptr<const JumpColumns> m_columns;
  std::size_t m_index;
  Eigen::Matrix2d m_gram;
  std::optional<std::size_t> m_onlyRow, m_wrongZeroArc;
};

const std::vector<Width>& jumpWidths();
/// Prior widths of a visible jump: the usual widths and, with probability 0.01, 30 plausible sizes.
const std::vector<Width>& usualAndFarWiderJumpWidths();

/// Returns jumps before each row and, with a common zero mark, before the zero of each position after the
/// first. In long sessions only every n-th of these moments is included.
///
/// A jump may last to the end of the session. If the positions are compared (`Linearised::isClosed`), a jump
/// may also end with its position, when the circle is set on the mark again. Jumps before the first row of a
/// position then belong to `wrongZeros`.
///
/// A jump that shows in one row only, which is alone in its visit, serves for comparison only. A gross error
/// of that row leaves the same trace and is more frequent.
std::vector<JumpComponent> jumpComponents(const Leftover& leftover);

/// Returns the jumps between the pointing zero of a position and its first visit. They end with the position.
/// With a common zero mark, a jump may also last to the end of the session or act on the zero alone. A
/// misread zero or a moved mark has the same trace. Empty if the positions are not compared, because only
/// their comparison shows these jumps.
std::vector<JumpComponent> wrongZeros(const Leftover& leftover);

}  // namespace alidade
