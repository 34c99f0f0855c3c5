#include "core/diagnosis/sparse_columns.h"

namespace alidade {

using Eigen::Index, Eigen::VectorXd;

void SparseColumns::add(Index row, Index first, const Eigen::RowVectorXd& values) {
  m_runs.push_back({row, first, values.size(), m_values.size()});
  m_values.insert(m_values.end(), values.begin(), values.end());
}

void SparseColumns::scale(double factor) {
  for (double& value : m_values) value *= factor;
}

SparseColumns::Run SparseColumns::run(std::size_t i) const {
  const Place& place = m_runs[i];
  return {place.row, place.first, {m_values.data() + place.begin, place.length}};
}

double SparseColumns::squaredNorm() const {
  return VectorXd::Map(m_values.data(), static_cast<Index>(m_values.size())).squaredNorm();
}

VectorXd SparseColumns::transposeTimes(const VectorXd& overReadings) const {
  VectorXd result = VectorXd::Zero(m_columns);
  for (const Place& place : m_runs) {
    const double factor = overReadings[place.row];
    const double* values = m_values.data() + place.begin;
    double* sums = result.data() + place.first;
    for (Index c = 0; c < place.length; ++c) sums[c] += factor * values[c];
  }
  return result;
}

VectorXd SparseColumns::times(const VectorXd& weights, Index readings) const {
  VectorXd result = VectorXd::Zero(readings);
  for (std::size_t i = 0; i < runs(); ++i) {
    const Run at = run(i);
    result[at.row] += at.values.dot(weights.segment(at.first, at.values.size()));
  }
  return result;
}

}  // namespace alidade
