#include "core/diagnosis/gap/leftover.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cassert>
#include <span>
#include <utility>

#include "core/adjustment/numerics/arc_angle_elimination.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

Leftover::Leftover(Linearised equations, const std::vector<EstimatedTerm>& inModel, double noise)
    : m_equations(std::move(equations)) {
  m_equations.weighZeros(noise);
  markVisits();
  MatrixXd base = layOutUnknowns(inModel, noise);
  eliminateArcAngles(base);
  const VectorXd scale = base.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  base *= scale.asDiagonal();
  const Eigen::ColPivHouseholderQR<Eigen::Ref<MatrixXd>> qr(base);  // computed in place
  const Index rank = qr.rank();
  m_basis.setZero(base.rows(), std::max<Index>(rank, 1));
  if (rank > 0) m_basis = qr.householderQ() * MatrixXd::Identity(base.rows(), rank);
  m_observed = outsideArcAngles(m_observed);
  m_residual = visible(m_observed);
  m_redundancy = VectorXd::Ones(readings());
  for (Index i = 0; i < readings(); ++i)
    m_redundancy[i] =
        !reading(i).takesPart ? 0 : 1 - reading(i).along * reading(i).along - m_basis.row(i).squaredNorm();
  Index counted = rows() - rank;
  for (Index v = 0; v < visits(); ++v) {
    const Run own = readingsOf(v);
    Index taking = 0;
    bool hasArcAngle = false;
    for (Index i = own.first; i < own.end; ++i) {
      taking += reading(i).takesPart ? 1 : 0;
      hasArcAngle = hasArcAngle || reading(i).along != 0;
    }
    counted -= own.length() - taking + (hasArcAngle ? 1 : 0);
  }
  m_degreesOfFreedom = static_cast<int>(counted);
}

void Leftover::markVisits() {
  m_along.resize(static_cast<Index>(m_equations.readings.size()));
  m_endOfVisit.assign(m_equations.visits, 0);
  Index i = 0;
  for (const LinearReading& reading : m_equations.readings) {
    m_along[i++] = reading.along;
    m_endOfVisit[reading.visit] = i;
  }
  for (std::size_t v = 1; v < m_endOfVisit.size(); ++v)
    m_endOfVisit[v] = std::max(m_endOfVisit[v], m_endOfVisit[v - 1]);
}

MatrixXd Leftover::layOutUnknowns(const std::vector<EstimatedTerm>& inModel, double noise) {
  const std::vector<std::size_t> unknowns = m_equations.uncertainUnknowns();
  const std::vector<PriorRow> priors = m_equations.priorRows(unknowns, inModel);
  const std::vector<Condition>& conditions = m_equations.conditions;
  const Index rows = readings() + std::ssize(priors) + std::ssize(conditions);
  MatrixXd base = MatrixXd::Zero(rows, std::ssize(unknowns) + std::ssize(inModel));
  m_observed.resize(rows);
  for (Index i = 0; i < readings(); ++i) m_observed[i] = reading(i).residual;
  Index column = 0;
  for (const std::size_t u : unknowns) {
    for (Index i = 0; i < readings(); ++i)
      base(i, column) = m_equations.ofUnknown(static_cast<std::size_t>(i), u);
    ++column;
  }
  for (const EstimatedTerm& term : inModel) base.col(column++).head(readings()) = this->column(term.term);
  Index row = readings();
  for (const PriorRow& prior : priors) {
    base(row, static_cast<Index>(prior.column)) = prior.derivative * noise;
    m_observed[row++] = prior.residual * noise;
  }
  for (const Condition& condition : conditions) {
    for (Index c = 0; const std::size_t u : unknowns) base(row, c++) = condition.derivatives[u] * noise;
    m_observed[row++] = condition.residual * noise;
  }
  return base;
}

void Leftover::eliminateArcAngles(MatrixXd& columns) const {
  const std::span along(m_along.data(), static_cast<std::size_t>(m_along.size()));
  for (Index c = 0; c < columns.cols(); ++c)
    alidade::eliminateArcAngles({columns.col(c).data(), along.size()}, along, m_endOfVisit);
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
  std::array<std::vector<double>, readingKinds> ofKinds;
  for (Index i = 0; i < readings(); ++i)
    ofKinds[static_cast<std::size_t>(reading(i).kind)].push_back(visible[i]);
  VectorXd products = VectorXd::Zero(static_cast<Index>(errorTermCount));
  for (std::size_t k = 0; k < readingKinds; ++k) {
    const Eigen::Map<const VectorXd> own(ofKinds[k].data(), std::ssize(ofKinds[k]));
    for (std::size_t term = 0; term < errorTermCount; ++term) {
      const auto column = m_equations.perTerm.of(static_cast<ReadingKind>(k), term);
      if (!column.empty())
        products[static_cast<Index>(term)] += Eigen::Map<const VectorXd>(column.data(), own.size()).dot(own);
    }
  }
  return products;
}

VectorXd Leftover::column(Unknown::Kind kind) const {
  VectorXd result = VectorXd::Zero(readings());
  for (std::size_t u = 0; u < m_equations.unknowns.size(); ++u) {
    if (m_equations.unknowns[u].kind != kind) continue;
    for (Index i = 0; i < readings(); ++i) result[i] += m_equations.ofUnknown(static_cast<std::size_t>(i), u);
  }
  return result;
}

double varianceOfReadings(const Leftover& leftover, const Eigen::VectorXd& perReading) {
  double variance = 0;
  for (Eigen::Index i = 0; i < std::min(perReading.size(), leftover.readings()); ++i)
    if (!leftover.reading(i).isZero) variance += perReading[i] * perReading[i];
  return variance;
}

}  // namespace alidade
