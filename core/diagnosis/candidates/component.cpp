#include "core/diagnosis/candidates/component.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/evidence/bent_fit.h"

namespace alidade {

using Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd Component::visibleColumns(const Leftover& leftover) const {
  return leftover.visible(wholeColumns(leftover));
}

void Component::fillProducts(const SharedProducts& with, Eigen::Ref<VectorXd> own) const {
  own = visibleColumns(with.leftover()).topRows(with.vector().size()).transpose() * with.vector();
}

VectorXd Component::products(const SharedProducts& with) const {
  VectorXd products(columns());
  fillProducts(with, products);
  return products;
}

VectorXd Component::wholeProducts(const SharedProducts& with) const {
  return wholeColumns(with.leftover()).transpose() * with.ofReadings();
}

VectorXd Component::times(const Leftover& leftover, const VectorXd& weights) const {
  return wholeColumns(leftover) * weights;
}

VectorXd Component::signature(const Leftover& leftover, const VectorXd& weights) const {
  return leftover.visible(times(leftover, weights));
}

double Component::signatureLength(const VectorXd& weights) const {
  return std::sqrt(signatureSquare(weights));
}

double Component::signatureSquare(const VectorXd& weights) const {
  const VectorXd taken = response() == Response::Bent ? VectorXd(bentWeights(weights)) : weights;
  return std::max(taken.dot(gram().lazyProduct(taken)), 0.0);  // lazyProduct avoids a heap allocation for
                                                               // these small matrices
}

namespace {

BentFit bentFitOf(const Component& component, const TurnedColumns& columns, double variance) {
  return fitBent(component.widths(), component.gram() - columns.shared * columns.shared.transpose(),
                 columns.right, variance);
}

}  // namespace

Gain Component::gain(const TurnedColumns& columns, double variance) const {
  switch (response()) {
    case Response::Linear:
      break;
    case Response::Bent:
      return bentFitOf(*this, columns, variance).gain;
    case Response::AllOrNothing: {
      const double square = columns.diagonal[0] - columns.shared.squaredNorm();
      return {(columns.right[0] - square / 2) / variance, 1};
    }
  }
  return gainOf(widths(), columns, variance);
}

LinearPart Component::linearPart(const TurnedColumns& columns, double variance) const {
  switch (response()) {
    case Response::Linear:
      break;
    case Response::Bent: {
      const VectorXd at = bentFitOf(*this, columns, variance).weights;
      const auto slope = bentDerivatives(at);
      return {false, bentWeights(at) - slope * at, slope};
    }
    case Response::AllOrNothing:
      return {false, VectorXd::Ones(1), MatrixXd(1, 0)};
  }
  return {};
}

double Component::widthOfFit(double width, const VectorXd& weights) const {
  const auto count = static_cast<double>(std::max<Eigen::Index>(weights.size(), 1));
  return std::max({1.0, width, std::sqrt(weights.squaredNorm() / count)});
}

std::vector<CauseParameter> Component::parameters(const GapModel&) const {
  return {};
}

CauseParameter estimatedParameter(const GapModel& after, std::string_view name, ErrorTerm term,
                                  std::string_view unit) {
  const std::size_t i = after.fit->indexOf(term);
  const double factor = modelUnitsPer(unit);
  return {std::string(name), after.fit->values[i] / factor, std::sqrt(after.fit->cofactor(i, i)) / factor,
          std::string(unit)};
}

}  // namespace alidade
