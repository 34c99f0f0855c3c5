#include "core/diagnosis/visible_terms.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/known_components.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double rounding = 1e-11;  // of a squared length, left of a column that is a combination of others

/// Takes the span of the first `count` columns off a Gram matrix, the plainest first; what rounding leaves of
/// a column that depends on others says nothing. `whole`: the squared lengths it counts against.
void eliminateFirst(MatrixXd& gram, Index count, const VectorXd& whole) {
  std::vector<Index> remaining;
  for (Index i = 0; i < count; ++i) remaining.push_back(i);
  const auto left = [&](Index i) { return whole[i] > 0 ? gram(i, i) / whole[i] : 0; };
  while (!remaining.empty()) {
    const auto plainest = std::ranges::max_element(remaining, {}, left);
    if (left(*plainest) <= rounding) return;
    const Index pivot = *plainest;
    remaining.erase(plainest);
    const VectorXd shared = gram.col(pivot) / std::sqrt(gram(pivot, pivot));
    gram.noalias() -= shared * shared.transpose();
  }
}

/// The equations of a set with the arc angles eliminated: those unknowns that are not fixed, then `terms`.
using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
RowMajorMatrix reducedEquations(const Linearised& set, const std::vector<std::size_t>& unknowns,
                                const std::vector<ErrorTerm>& ofTerms) {
  const auto count = static_cast<Index>(unknowns.size()), terms = static_cast<Index>(ofTerms.size()),
             readings = static_cast<Index>(set.readings.size());
  RowMajorMatrix rows(readings, count + terms);
  for (Index i = 0; i < readings; ++i) {
    const auto reading = static_cast<std::size_t>(i);
    double* row = rows.row(i).data();
    for (const std::size_t unknown : unknowns) *row++ = set.ofUnknown(reading, unknown);
    for (const ErrorTerm term : ofTerms) *row++ = set.ofTerm(reading, term);
  }
  Eigen::RowVectorXd share(count + terms);
  for (Index first = 0, next = 0; first < readings; first = next) {
    const auto at = [&](Index i) -> const LinearReading& {
      return set.readings[static_cast<std::size_t>(i)];
    };
    share.setZero();
    for (; next < readings && at(next).visit == at(first).visit; ++next)
      share += at(next).along * rows.row(next);
    for (Index i = first; i < next; ++i) rows.row(i) -= at(i).along * share;
  }
  return rows;
}

}  // namespace

VisibleTerms visibleTerms(const Linearised& set, const std::vector<ErrorTerm>& ofTerms) {
  std::vector<std::size_t> unknowns;
  for (std::size_t u = 0; u < set.unknowns.size(); ++u)
    if (set.priorSigmas[u] > 0) unknowns.push_back(u);
  const auto count = static_cast<Index>(unknowns.size()), size = static_cast<Index>(errorTermCount);
  const RowMajorMatrix rows = reducedEquations(set, unknowns, ofTerms);
  MatrixXd gram = MatrixXd::Zero(rows.cols(), rows.cols());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
  gram = MatrixXd(gram.selfadjointView<Eigen::Lower>());
  for (Index u = 0; u < count; ++u) {
    const double sigma = set.priorSigmas[unknowns[static_cast<std::size_t>(u)]];
    if (!std::isinf(sigma)) gram(u, u) += 1 / (sigma * sigma);
  }
  const VectorXd whole = gram.diagonal();
  eliminateFirst(gram, count, whole);
  VisibleTerms terms{MatrixXd::Zero(size, size), VectorXd::Zero(size)};
  for (std::size_t i = 0; i < ofTerms.size(); ++i) {
    const auto term = static_cast<Index>(ofTerms[i]), own = count + static_cast<Index>(i);
    terms.whole[term] = whole[own];
    for (std::size_t j = 0; j < ofTerms.size(); ++j)
      terms.gram(term, static_cast<Index>(ofTerms[j])) = gram(own, count + static_cast<Index>(j));
  }
  return terms;
}

VisibleTerms operator+(const VisibleTerms& one, const VisibleTerms& other) {
  return {one.gram + other.gram, one.whole + other.whole};
}

VisibleTerms withEstimated(VisibleTerms terms, const std::vector<EstimatedTerm>& estimated) {
  const auto count = static_cast<Index>(estimated.size()), size = terms.gram.rows();
  if (count == 0) return terms;
  // Each estimated term once more in front, where its prior counts, and what it takes up is taken off the
  // rest.
  MatrixXd chosen = MatrixXd::Zero(size, count + size);
  chosen.rightCols(size).setIdentity();
  for (Index i = 0; i < count; ++i)
    chosen(static_cast<Index>(estimated[static_cast<std::size_t>(i)].term), i) = 1;
  MatrixXd gram = chosen.transpose() * terms.gram * chosen;
  for (Index i = 0; i < count; ++i) {
    const double sigma = estimated[static_cast<std::size_t>(i)].priorSigma;
    if (!std::isinf(sigma)) gram(i, i) += 1 / (sigma * sigma);
  }
  eliminateFirst(gram, count, gram.diagonal());
  terms.gram = gram.bottomRightCorner(size, size);
  return terms;
}

MatrixXd combinationOf(const Effect& effect) {
  MatrixXd combination =
      MatrixXd::Zero(static_cast<Index>(errorTermCount), static_cast<Index>(effect.parameters.size()));
  for (std::size_t p = 0; p < effect.parameters.size(); ++p)
    combination(static_cast<Index>(effect.parameters[p].term), static_cast<Index>(p)) =
        plausibleSize(effect.parameters[p]);
  return combination;
}

double lengthOf(const VisibleTerms& terms, const VectorXd& combination) {
  return std::sqrt(std::max(combination.dot(terms.gram * combination), 0.0));
}

double differenceFrom(const VisibleTerms& terms, const VectorXd& combination, const Effect& effect) {
  MatrixXd both(combination.size(), static_cast<Index>(effect.parameters.size()) + 1);
  both << combinationOf(effect), combination;
  MatrixXd gram = both.transpose() * terms.gram * both;
  const Index own = both.cols() - 1;
  if (isAllOrNothing(effect)) {
    const double trace = gram(own, own), apart = trace - 2 * gram(0, own) + gram(0, 0);
    return std::sqrt(std::max(std::min(trace, apart), 0.0));
  }
  eliminateFirst(gram, own, both.cwiseAbs2().transpose() * terms.whole);
  return std::sqrt(std::max(gram(own, own), 0.0));
}

}  // namespace alidade
