#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "core/diagnosis/candidates/jump_moment.h"
#include "core/diagnosis/candidates/shared_products.h"
#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/effects/catalogue.h"

namespace alidade {

/// How a component takes part in the linear model: its columns with the weights `fixed` + `slope` times what
/// is estimated.
struct LinearPart {
  bool isPlain = true;  ///< 0 + 1 times
  Eigen::VectorXd fixed = {};
  Eigen::MatrixXd slope = {};
};

/// What a gap can be made of: a few columns over the readings, scaled so that a weight of 1 is the plausible
/// size (1σ) of the cause; its weights are normal around zero with a width that is itself uncertain. The
/// columns are not kept: they are made anew of the leftover where their inner products do not serve.
///
/// `leftover` is everywhere the one that the component was made of.
class Component {
 public:
  virtual ~Component() = default;

  /// Of the cause, or what a shape follows; static text.
  virtual std::string_view id() const = 0;
  virtual ErrorSource source() const = 0;
  virtual Response response() const { return Response::Linear; }
  /// That its weights may have, the narrowest first.
  virtual const std::vector<Width>& widths() const = 0;

  /// One of several named causes, each there or not: told by how well it explains the gap alone, and compared
  /// with those that leave nearly the same.
  virtual bool isEffect() const { return false; }
  /// Its size is known beforehand and in the model: what is left for it to explain is that what is known
  /// holds no longer.
  virtual bool isKnown() const { return false; }
  /// 1σ of each weight, in plausible sizes, as far as is known beforehand.
  virtual Eigen::VectorXd usualSizes() const { return Eigen::VectorXd::Ones(weights()); }
  /// A step of the orientation, of which a session has one at most.
  virtual bool isJump() const { return false; }
  /// The arc that a jump between its zero and its first place moves as a whole.
  virtual std::optional<std::size_t> slippedArc() const { return std::nullopt; }
  /// Of a jump: on which rows it acts.
  virtual std::optional<JumpMoment> jumpMoment() const { return std::nullopt; }
  /// Of no named cause.
  virtual bool isShape() const { return false; }
  /// The one that is off, an index into the leftover's readings; absent where the model is.
  virtual std::optional<Eigen::Index> grossErrorAt() const { return std::nullopt; }
  /// Sequence of the only row that would show it: a gross error there leaves the same, and is the commoner.
  virtual std::optional<std::size_t> onlyRow() const { return std::nullopt; }

  /// Inner products of the visible columns with one another, of what bends with the second derivatives
  /// behind.
  virtual Eigen::Map<const Eigen::MatrixXd> gram() const = 0;
  /// How many there are, with the second derivatives.
  Eigen::Index columns() const { return gram().cols(); }
  virtual Eigen::Index weights() const { return columns(); }
  /// Over the readings, visible or not, without the second derivatives.
  virtual Eigen::MatrixXd wholeColumns(const Leftover& leftover) const = 0;
  /// The visible parts, the second derivatives behind them.
  virtual Eigen::MatrixXd visibleColumns(const Leftover& leftover) const;
  /// Inner products of the visible columns with a vector that is visible. `own`: columns() long.
  virtual void fillProducts(const SharedProducts& with, Eigen::Ref<Eigen::VectorXd> own) const;
  Eigen::VectorXd products(const SharedProducts& with) const;
  /// Inner products of the whole columns with any vector.
  virtual Eigen::VectorXd wholeProducts(const SharedProducts& with) const;
  /// The whole columns times weights, over the readings.
  virtual Eigen::VectorXd times(const Leftover& leftover, const Eigen::VectorXd& weights) const;
  /// What the weights leave in the readings, visible part: linear, and bent where it bends.
  virtual Eigen::VectorXd signature(const Leftover& leftover, const Eigen::VectorXd& weights) const;
  /// Its length and the square of it, from the inner products of the columns.
  virtual double signatureLength(const Eigen::VectorXd& weights) const;
  double signatureSquare(const Eigen::VectorXd& weights) const;

  /// What it adds to the evidence. `columns`: its own, turned unless it bends.
  virtual Gain gain(const TurnedColumns& columns, double variance) const;
  LinearPart linearPart(const TurnedColumns& columns, double variance) const;

  /// To estimate weights with that were found so, where `width` is the likeliest, in plausible sizes: that
  /// they are larger than plausible is no misfit of the readings.
  virtual double widthOfFit(double width, const Eigen::VectorXd& weights) const;

  /// Adds to a model what stands for it there. `weights`: to start from; `width`: to estimate it with; both
  /// in plausible sizes.
  virtual void addTo(JointFitOptions& model, const Leftover& leftover, const Eigen::VectorXd& weights,
                     double width) const = 0;
  /// Its numbers as the answer tells them. `after`: a fit with it in the model.
  virtual std::vector<CauseParameter> parameters(const GapModel& after) const;

 protected:
  Component() = default;
  Component(const Component&) = default;
  Component(Component&&) = default;
  Component& operator=(const Component&) = default;
  Component& operator=(Component&&) = default;
};

/// A number of a cause as the model with it has it. `unit`: one of the catalogue's.
CauseParameter estimatedParameter(const GapModel& after, std::string_view name, ErrorTerm term,
                                  std::string_view unit);

}  // namespace alidade
