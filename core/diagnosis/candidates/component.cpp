#include "core/diagnosis/candidates/component.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector2d, Eigen::VectorXd;

namespace {

std::vector<Width> evenly(std::initializer_list<double> sigmas) {
  std::vector<Width> widths;
  for (const double sigma : sigmas) widths.push_back({sigma, -std::log(static_cast<double>(sigmas.size()))});
  return widths;
}

/// A knock may be of any size; instruments and guideways are adjusted.
std::vector<Width> andFarWider(std::vector<Width> widths, double sigma) {
  constexpr double chance = 0.01;
  for (Width& width : widths) width.logChance += std::log1p(-chance);
  widths.push_back({sigma, std::log(chance)});
  return widths;
}

}  // namespace

const std::vector<Width>& widthsOf(Component::Kind kind) {
  static const std::array widths{evenly({0.1, 0.3, 1, 3}), evenly({0.3, 1}), evenly({8, 30, 120, 1000}),
                                 evenly({0.5, 1, 2, 4, 8, 16})};
  using enum Component::Kind;
  static_assert(Effect == Component::Kind{0} && Jump == Component::Kind{1} &&
                Misreading == Component::Kind{2} && Shape == Component::Kind{3});
  return widths[static_cast<std::size_t>(kind)];
}

const std::vector<Width>& widthsOfKnocks() {
  static const std::vector<Width> widths = andFarWider(widthsOf(Component::Kind::Jump), 30);
  return widths;
}

MatrixXd wholeColumns(const Leftover& leftover, const Component& component) {
  if (component.kind == Component::Kind::Jump) {
    MatrixXd columns(leftover.readings(), 2);
    columns << leftover.column(ErrorTerm::HorizontalJump), leftover.column(ErrorTerm::VerticalJump);
    for (Index i = 0; i < columns.rows(); ++i)
      if (leftover.reading(i).sequence < component.moment) columns.row(i).setZero();
    return columns * plausibleJump;
  }
  if (component.kind == Component::Kind::Shape) {
    const Index count = component.pattern.columns();
    MatrixXd columns(leftover.readings(), count);
    for (Index c = 0; c < count; ++c) columns.col(c) = component.pattern.times(VectorXd::Unit(count, c));
    return columns;
  }
  const std::vector<EffectParameter>& parameters = component.effect->parameters;
  MatrixXd columns(leftover.readings(), static_cast<Index>(parameters.size()));
  for (std::size_t p = 0; p < parameters.size(); ++p)
    columns.col(static_cast<Index>(p)) = leftover.column(parameters[p].term) * plausibleSize(parameters[p]);
  return columns;
}

MatrixXd visibleColumns(const Leftover& leftover, const Component& component) {
  MatrixXd columns = leftover.visible(wholeColumns(leftover, component));
  const Index linear = columns.cols(), bent = component.curvature.cols();
  if (bent == 0) return columns;
  columns.conservativeResize(Eigen::NoChange, linear + bent);
  columns.rightCols(bent) = component.curvature;
  return columns;
}

VectorXd productsWith(const VectorXd& visible, const VectorXd& ofTerms, const Component& component) {
  const std::vector<EffectParameter>& parameters = component.effect->parameters;
  const auto linear = static_cast<Index>(parameters.size()), bent = component.curvature.cols();
  VectorXd products(linear + bent);
  for (Index p = 0; p < linear; ++p) {
    const EffectParameter& parameter = parameters[static_cast<std::size_t>(p)];
    products[p] = ofTerms[static_cast<Index>(parameter.term)] * plausibleSize(parameter);
  }
  if (bent > 0) products.tail(bent) = component.curvature.transpose() * visible;
  return products;
}

Eigen::Vector<double, 5> bentWeights(const Vector2d& weights) {
  const double x = weights[0], y = weights[1];
  return {x, y, x * x / 2, x * y, y * y / 2};
}

Eigen::Matrix<double, 5, 2> bentDerivatives(const Vector2d& weights) {
  const double x = weights[0], y = weights[1];
  Eigen::Matrix<double, 5, 2> derivatives;
  derivatives << 1, 0, 0, 1, x, 0, y, x, 0, y;
  return derivatives;
}

VectorXd signature(const Leftover& leftover, const Component& component, const VectorXd& weights) {
  if (component.kind == Component::Kind::Shape) return leftover.visible(component.pattern.times(weights));
  VectorXd linear = leftover.visible(wholeColumns(leftover, component) * weights);
  if (component.curvature.cols() > 0) linear += component.curvature * bentWeights(weights).tail<3>();
  return linear;
}

double signatureSquare(const Component& component, const VectorXd& weights) {
  const bool isBent = component.curvature.cols() > 0;
  const MatrixXd& gram = isBent ? component.bentGram : component.gram;
  const VectorXd taken = isBent ? VectorXd(bentWeights(weights)) : weights;
  return std::max(taken.dot(gram.lazyProduct(taken)), 0.0);  // small: no room on the heap
}

}  // namespace alidade
