#include "core/diagnosis/component.h"

#include <cmath>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

std::vector<Width> evenly(std::initializer_list<double> sigmas) {
  std::vector<Width> widths;
  for (const double sigma : sigmas) widths.push_back({sigma, -std::log(static_cast<double>(sigmas.size()))});
  return widths;
}

}  // namespace

const std::vector<Width>& widthsOf(Component::Kind kind) {
  static const std::vector<Width> effect = evenly({0.1, 0.3, 1, 3});
  static const std::vector<Width> jump = evenly({0.3, 1});
  static const std::vector<Width> misreading = evenly({8, 30, 120, 1000});
  static const std::vector<Width> shape = evenly({0.5, 1, 2, 4, 8, 16});
  switch (kind) {
    case Component::Kind::Effect:
      return effect;
    case Component::Kind::Jump:
      return jump;
    case Component::Kind::Misreading:
      return misreading;
    case Component::Kind::Shape:
      return shape;
  }
  return effect;
}

MatrixXd wholeColumns(const Leftover& leftover, const Component& component) {
  if (component.kind == Component::Kind::Jump) {
    MatrixXd columns(leftover.readings(), 2);
    columns << leftover.column(ErrorTerm::HorizontalJump), leftover.column(ErrorTerm::VerticalJump);
    for (Index i = 0; i < columns.rows(); ++i)
      if (leftover.reading(i).sequence < component.moment) columns.row(i).setZero();
    return columns * plausibleJump;
  }
  const std::vector<EffectParameter>& parameters = component.effect->parameters;
  MatrixXd columns(leftover.readings(), static_cast<Index>(parameters.size()));
  for (std::size_t p = 0; p < parameters.size(); ++p)
    columns.col(static_cast<Index>(p)) = leftover.column(parameters[p].term) * plausibleSize(parameters[p]);
  return columns;
}

VectorXd signature(const Component& component, const VectorXd& weights) {
  VectorXd result = component.columns * weights;
  if (component.curvature.cols() == 0) return result;
  const Eigen::Vector3d second(weights[0] * weights[0] / 2, weights[0] * weights[1],
                               weights[1] * weights[1] / 2);
  return result + component.curvature * second;
}

}  // namespace alidade
