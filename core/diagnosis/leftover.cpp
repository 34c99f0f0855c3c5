#include "core/diagnosis/leftover.h"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

Leftover::Leftover(Linearised equations, const std::vector<EstimatedTerm>& inModel)
    : m_equations(std::move(equations)) {
  numberVisits();
  MatrixXd base = layOutUnknowns(inModel);
  eliminateArcAngles(base);
  const VectorXd scale = base.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  base *= scale.asDiagonal();
  const Eigen::ColPivHouseholderQR<Eigen::Ref<MatrixXd>> qr(base);  // in its place
  m_basis = qr.householderQ() * MatrixXd::Identity(base.rows(), qr.rank());
  m_observed = outsideArcAngles(m_observed);
  m_residual = visible(m_observed);
  m_residualByTerms = productsOfTerms(m_residual);
  m_redundancy = VectorXd::Ones(readings());
  for (Index i = 0; i < readings(); ++i)
    m_redundancy[i] =
        !reading(i).takesPart ? 0 : 1 - reading(i).along * reading(i).along - m_basis.row(i).squaredNorm();
  Index counted = rows() - m_basis.cols();
  for (const auto& visit : m_visits) {
    const auto taking = std::ranges::count_if(visit, [&](Index i) { return reading(i).takesPart; });
    counted -= static_cast<Index>(visit.size()) - taking + (taking > 0 ? 1 : 0);
  }
  m_degreesOfFreedom = static_cast<int>(counted);
}

void Leftover::numberVisits() {
  m_along.resize(static_cast<Index>(m_equations.readings.size()));
  m_visits.resize(m_equations.visits);
  Index i = 0;
  for (const LinearReading& reading : m_equations.readings) {
    auto& visit = m_visits[reading.visit];
    if (visit.empty()) visit.reserve(2);
    visit.push_back(i);
    m_along[i++] = reading.along;
  }
  m_endOfVisit.reserve(m_visits.size());
  for (const auto& visit : m_visits) m_endOfVisit.push_back(visit.empty() ? 0 : visit.back() + 1);
}

MatrixXd Leftover::layOutUnknowns(const std::vector<EstimatedTerm>& inModel) {
  Index columns = static_cast<Index>(inModel.size()), priors = 0;
  for (const EstimatedTerm& term : inModel) priors += std::isinf(term.priorSigma) ? 0 : 1;
  for (const double sigma : m_equations.priorSigmas) {
    columns += sigma > 0 ? 1 : 0;
    priors += sigma > 0 && !std::isinf(sigma) ? 1 : 0;
  }
  MatrixXd base = MatrixXd::Zero(readings() + priors, columns);
  VectorXd& observed = m_observed;
  observed = VectorXd::Zero(readings() + priors);
  Index column = 0, prior = readings();
  const auto known = [&](double sigma, double residual) {
    if (!std::isinf(sigma)) {
      observed[prior] = residual;
      base(prior++, column) = 1 / sigma;
    }
    ++column;
  };
  for (Index i = 0; i < readings(); ++i) observed[i] = reading(i).residual;
  for (std::size_t u = 0; u < m_equations.unknowns.size(); ++u) {
    if (m_equations.priorSigmas[u] <= 0) continue;
    for (Index i = 0; i < readings(); ++i)
      base(i, column) = m_equations.ofUnknown(static_cast<std::size_t>(i), u);
    known(m_equations.priorSigmas[u], m_equations.priorResiduals[u]);
  }
  for (const EstimatedTerm& term : inModel) {
    base.col(column).head(readings()) = this->column(term.term);
    const double value = m_equations.termValues[static_cast<std::size_t>(term.term)];
    known(term.priorSigma, (term.priorValue - value) / term.priorSigma);
  }
  return base;
}

void Leftover::eliminateArcAngles(MatrixXd& columns) const {
  for (Index c = 0; c < columns.cols(); ++c) {
    double* column = columns.col(c).data();
    Index first = 0;
    for (const Index end : m_endOfVisit) {
      if (end - first == 2) {  // by far the commonest, and too short for a loop
        const double along = m_along[first], next = m_along[first + 1],
                     share = along * column[first] + next * column[first + 1];
        column[first] -= share * along;
        column[first + 1] -= share * next;
      } else {
        double share = 0;
        for (Index i = first; i < end; ++i) share += m_along[i] * column[i];
        for (Index i = first; i < end; ++i) column[i] -= share * m_along[i];
      }
      first = std::max(first, end);
    }
  }
}

MatrixXd Leftover::outsideArcAngles(const MatrixXd& columns) const {
  MatrixXd result(m_observed.size(), columns.cols());
  result.topRows(columns.rows()) = columns;
  result.bottomRows(result.rows() - columns.rows()).setZero();
  eliminateArcAngles(result);
  return result;
}

MatrixXd Leftover::visible(const MatrixXd& columns) const {
  MatrixXd result = outsideArcAngles(columns);
  const MatrixXd taken = m_basis.transpose() * result;
  result.noalias() -= m_basis * taken;
  return result;
}

VectorXd Leftover::column(ErrorTerm term) const {
  VectorXd result(readings());
  for (Index i = 0; i < readings(); ++i) result[i] = m_equations.ofTerm(static_cast<std::size_t>(i), term);
  return result;
}

VectorXd Leftover::productsOfTerms(const VectorXd& visible) const {
  using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const RowMajorMatrix> perTerm(m_equations.perTerm.data(), readings(),
                                                 static_cast<Index>(m_equations.terms));
  const VectorXd own = perTerm.transpose() * visible.head(readings());
  VectorXd products = VectorXd::Zero(static_cast<Index>(errorTermCount));
  for (Index term = 0; term < products.size(); ++term)
    if (const std::size_t slot = m_equations.slots[static_cast<std::size_t>(term)]; slot > 0)
      products[term] = own[static_cast<Index>(slot) - 1];
  return products;
}

VectorXd Leftover::column(Unknown::Kind kind) const {
  VectorXd result = VectorXd::Zero(readings());
  for (std::size_t u = 0; u < m_equations.unknowns.size(); ++u) {
    if (m_equations.unknowns[u].kind != kind) continue;
    for (Index i = 0; i < readings(); ++i)
      if (m_equations.unknowns[u].concerns(reading(i).arc))
        result[i] = m_equations.ofUnknown(static_cast<std::size_t>(i), u);
  }
  return result;
}

}  // namespace alidade
