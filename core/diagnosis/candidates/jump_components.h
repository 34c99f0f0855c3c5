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

/// The orientation jumps before a row.
class JumpComponent final : public Component {
 public:
  /// `columns`: of many moments, of which this is the `index`-th. `gram`: of its visible columns.
  JumpComponent(std::shared_ptr<const JumpColumns> columns, std::size_t index, Eigen::Matrix2d gram,
                std::optional<std::size_t> onlyRow);

  /// Sequences of the first row after it, and of the first on which it acts no longer.
  JumpMoment moment() const { return m_columns->moments()[m_index]; }

  std::string_view id() const override;
  ErrorSource source() const override { return ErrorSource::Time; }
  const std::vector<Width>& widths() const override;
  bool isJump() const override { return true; }
  std::optional<std::size_t> slippedArc() const override { return m_slippedArc; }
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

  void setSlippedArc(std::size_t arc) { m_slippedArc = arc; }

 private:
  std::shared_ptr<const JumpColumns> m_columns;
  std::size_t m_index;
  Eigen::Matrix2d m_gram;
  std::optional<std::size_t> m_onlyRow, m_slippedArc;
};

const std::vector<Width>& jumpWidths();
/// Of a jump that shows: as of any, and now and then 30 times its plausible size.
const std::vector<Width>& usualAndFarWiderJumpWidths();

/// A jump before any row, or before the zero of a position after the first; of long sessions before every
/// n-th. Where the positions are held against each other (`Linearised::isClosed`), one that lasts and, before
/// the last position, one that lasts to the end of its own, the circle having been set anew on the mark;
/// those before the first row of a position are `zeroSlips`. One that a single row alone in its visit would
/// show leaves what a gross error of that row leaves, which is the commoner: it is for comparison only.
std::vector<JumpComponent> jumpComponents(const Leftover& leftover);

/// A jump between the pointing zero of a position and its first place, that lasts or ends with the position,
/// and that zero misread or its mark moved, where the positions are held against each other; else nothing
/// would show it.
std::vector<JumpComponent> zeroSlips(const Leftover& leftover);

}  // namespace alidade
