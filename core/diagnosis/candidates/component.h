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

/// The weights of a component in the linear model: `fixed` + `slope` × the estimated parameters.
struct LinearPart {
  bool isPlain = true;  ///< whether `fixed` = 0 and `slope` = 1
  Eigen::VectorXd fixed = {};
  Eigen::MatrixXd slope = {};
};

/// A possible part of the gap: a few columns over the readings. A weight of 1 is the plausible size (1σ) of
/// the cause. The prior of the weights is normal with mean 0 and an uncertain width. The columns are not
/// stored: they are computed from the leftover where the inner products do not suffice.
///
/// Every parameter `leftover` must be the leftover from which the component was made.
class Component {
 public:
  virtual ~Component() = default;

  /// Identifier of the cause, or the argument that a pattern follows; static text.
  virtual std::string_view id() const = 0;
  virtual ErrorSource source() const = 0;
  virtual Response response() const { return Response::Linear; }
  /// Possible prior widths of the weights, the narrowest first.
  virtual const std::vector<Width>& widths() const = 0;

  /// Whether this is an effect of the catalogue or of the user. Effects are ranked by how well each alone
  /// explains the gap, and compared with their look-alikes.
  virtual bool isEffect() const { return false; }
  /// Whether the size is known and in the model. The component then means that the known value is out of
  /// date.
  virtual bool isKnown() const { return false; }
  /// Prior σ of each weight, in plausible sizes.
  virtual Eigen::VectorXd usualSizes() const { return Eigen::VectorXd::Ones(weights()); }
  /// Whether this is a jump of the orientation. An explanation contains at most one jump.
  virtual bool isJump() const { return false; }
  /// For a jump between the zero and the first visit of an arc: index of the arc, which moves as a whole.
  virtual std::optional<std::size_t> wrongZeroArc() const { return std::nullopt; }
  /// The rows on which a jump acts. Absent for other components.
  virtual std::optional<JumpMoment> jumpMoment() const { return std::nullopt; }
  /// Whether this is a pattern without a named cause.
  virtual bool isShape() const { return false; }
  /// Index of the reading with a gross error among the leftover's readings. Absent for other components.
  virtual std::optional<Eigen::Index> grossErrorAt() const { return std::nullopt; }
  /// Order (`Sighting::order`) of the row, for a jump that only one row shows. A gross error of this row
  /// leaves the same trace and is more frequent.
  virtual std::optional<std::size_t> onlyRow() const { return std::nullopt; }

  /// Gram matrix of the visible columns. For a bent component the visible second derivatives follow the
  /// columns.
  virtual Eigen::Map<const Eigen::MatrixXd> gram() const = 0;
  /// Number of columns, second derivatives included.
  Eigen::Index columns() const { return gram().cols(); }
  virtual Eigen::Index weights() const { return columns(); }
  /// Columns over all readings, before projection, without the second derivatives.
  virtual Eigen::MatrixXd wholeColumns(const Leftover& leftover) const = 0;
  /// Visible parts of the columns, followed by the visible second derivatives.
  virtual Eigen::MatrixXd visibleColumns(const Leftover& leftover) const;
  /// Fills `own` (`columns()` long) with the inner products of the visible columns with a visible vector.
  virtual void fillProducts(const SharedProducts& with, Eigen::Ref<Eigen::VectorXd> own) const;
  Eigen::VectorXd products(const SharedProducts& with) const;
  /// Inner products of the whole columns with any vector.
  virtual Eigen::VectorXd wholeProducts(const SharedProducts& with) const;
  /// Product of the whole columns and the weights, over the readings.
  virtual Eigen::VectorXd times(const Leftover& leftover, const Eigen::VectorXd& weights) const;
  /// Visible trace of the weights in the readings: linear, with the second-order terms for a bent component.
  virtual Eigen::VectorXd signature(const Leftover& leftover, const Eigen::VectorXd& weights) const;
  /// Length of the trace and its square, from the Gram matrix.
  virtual double signatureLength(const Eigen::VectorXd& weights) const;
  double signatureSquare(const Eigen::VectorXd& weights) const;

  /// Gain in evidence from the component. `columns` are its own, rotated unless the component is bent.
  virtual Gain gain(const TurnedColumns& columns, double variance) const;
  LinearPart linearPart(const TurnedColumns& columns, double variance) const;

  /// Prior width for a fit with the component, in plausible sizes. `weights` were found with the most likely
  /// `width`. The result covers the weights, since a prior that is too narrow increases χ².
  virtual double widthOfFit(double width, const Eigen::VectorXd& weights) const;

  /// Adds the terms of the component to a model. `weights` are the start values; `width` is the prior width;
  /// both in plausible sizes.
  virtual void addTo(JointFitOptions& model, const Leftover& leftover, const Eigen::VectorXd& weights,
                     double width) const = 0;
  /// Parameters of the cause for the result. `after` is a fit that contains the component.
  virtual std::vector<CauseParameter> parameters(const GapModel& after) const;

 protected:
  Component() = default;
  Component(const Component&) = default;
  Component(Component&&) = default;
  Component& operator=(const Component&) = default;
  Component& operator=(Component&&) = default;
};

/// Returns a parameter of a cause as estimated by the model that contains it. `unit` is a unit of the
/// catalogue.
CauseParameter estimatedParameter(const GapModel& after, std::string_view name, ErrorTerm term,
                                  std::string_view unit);

}  // namespace alidade
