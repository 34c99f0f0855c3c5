#pragma once

#include <Eigen/Core>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "core/diagnosis/candidates/pattern.h"
#include "core/effects/catalogue.h"

namespace alidade {

// What a gap can be made of. Every component is a few columns over the readings, scaled so that a weight of
// 1 is the plausible size (1σ) of the effect; its weights are normal around zero with a width that is
// itself uncertain. The columns are not kept: they are made anew of the leftover where their inner products
// do not serve.

/// How wide the weights of a component may be, and how likely.
struct Width {
  double sigma;      ///< in plausible sizes
  double logChance;  ///< natural
};

struct Component {
  enum class Kind {
    Effect,      ///< of the catalogue
    Jump,        ///< the orientation steps before a row
    Misreading,  ///< one reading is off; no columns, since they would be those of a unit matrix
    Shape,       ///< a pattern of no named cause
  };

  Kind kind = Kind::Effect;
  std::string_view id;  ///< of the effect, or what the pattern follows; static text
  ErrorSource source = ErrorSource::Instrument;
  const Effect* effect = nullptr;  ///< of an Effect
  std::size_t moment = 0;          ///< of a Jump: sequence of the first row after it
  std::optional<std::size_t> onlyRow =
      {};                     ///< of a Jump that one row shows; not sought where misreadings are
  Eigen::Index reading = 0;   ///< of a Misreading: index into the leftover's readings
  Pattern pattern = {};       ///< of a Shape: over the readings
  Eigen::MatrixXd gram = {};  ///< inner products of the visible columns with one another
  /// Of an effect of two weights that bends: visible second derivatives, columns 11, 12, 22. Else empty.
  Eigen::MatrixXd curvature = {};
  Eigen::MatrixXd bentGram = {};  ///< inner products of the columns and the curvature behind them; else empty
  bool allOrNothing = false;      ///< its one weight is 1
  double logPrior = 0;            ///< natural, odds against nothing at all
};

/// What is believed before the readings are seen, in odds against "no gap at all". Broad on purpose: a factor
/// of two in any of them moves no clear answer.
struct PriorOdds {
  double effect = 0.04;      ///< each
  double jump = 0.04;        ///< shared by all moments
  double misreading = 0.08;  ///< shared by all readings
  double noise = 0.04;       ///< larger than stated
  double shape = 0.04;       ///< shared by all patterns
};

/// Plausible size (1σ) of a step of the orientation, rad: 60″.
inline constexpr double plausibleJump = 60.0 / 3600 * std::numbers::pi / 180;

/// Effects small and large beside their plausible size: 0.1, 0.3, 1 and 3 times.
const std::vector<Width>& widthsOf(Component::Kind kind);
/// Of a jump that shows: as of any, and now and then 30 times its plausible size.
const std::vector<Width>& widthsOfKnocks();

/// The columns of a component that has any over the readings, visible or not.
Eigen::MatrixXd wholeColumns(const Leftover& leftover, const Component& component);

/// The visible part of the columns; the curvature behind them where the component bends.
Eigen::MatrixXd visibleColumns(const Leftover& leftover, const Component& component);
/// Of an effect: the inner products of its visible columns, and of its curvature behind them, with a visible
/// vector. `ofTerms`: those of the terms with it, `Leftover::productsOfTerms`.
Eigen::VectorXd productsWith(const Eigen::VectorXd& visible, const Eigen::VectorXd& ofTerms,
                             const Component& component);

/// Of a bending component: the five weights (x, y, ½x², xy, ½y²) that columns and curvature take, and their
/// derivatives by x and y.
Eigen::Vector<double, 5> bentWeights(const Eigen::Vector2d& weights);
Eigen::Matrix<double, 5, 2> bentDerivatives(const Eigen::Vector2d& weights);

/// What the weights leave in the readings, visible part: linear, and bent where the component bends.
Eigen::VectorXd signature(const Leftover& leftover, const Component& component,
                          const Eigen::VectorXd& weights);
/// Its squared length, from the inner products of the columns.
double signatureSquare(const Component& component, const Eigen::VectorXd& weights);

}  // namespace alidade
