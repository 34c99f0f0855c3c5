#include "core/diagnosis/observability/visible_terms.h"

#include <algorithm>
#include <cmath>

#include "core/adjustment/numerics/arc_angle_elimination.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double rounding = 1e-11;  // of a squared length; a remainder below it means a linearly dependent
                                    // column

/// Eliminates the span of the first `count` columns from a Gram matrix, the best determined column first.
/// `whole` are the squared lengths of the columns: a remainder that is small compared with them is a rounding
/// error of a linearly dependent column and is ignored.
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

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The columns of a set: unknowns that are not fixed, terms, then jumps.
struct Columns {
  const Linearised& set;
  const std::vector<std::size_t>& unknowns;
  const std::vector<ErrorTerm>& terms;
  const std::vector<JumpMoment>& moments;

  Index count() const { return static_cast<Index>(unknowns.size() + terms.size() + 2 * moments.size()); }
  Index readings() const { return static_cast<Index>(set.readings.size()); }
  const LinearReading& reading(Index i) const { return set.readings[static_cast<std::size_t>(i)]; }
  bool areOfOneVisit(Index i, Index j) const { return reading(i).visit == reading(j).visit; }
};

/// Returns the equations of whole visits after elimination of the arc angles, for the readings from `begin`
/// to before `end`.
void reduce(const Columns& columns, Index begin, Index end, RowMajorMatrix& rows) {
  rows.resize(end - begin, columns.count());
  for (Index i = begin; i < end; ++i) {
    const auto reading = static_cast<std::size_t>(i);
    double* row = rows.row(i - begin).data();
    for (const std::size_t unknown : columns.unknowns) *row++ = columns.set.ofUnknown(reading, unknown);
    for (const ErrorTerm term : columns.terms) *row++ = columns.set.ofTerm(reading, term);
    for (const JumpMoment& moment : columns.moments)
      for (const ErrorTerm step : {ErrorTerm::HorizontalJump, ErrorTerm::VerticalJump})
        *row++ = moment.actsOn(columns.reading(i).sequence) ? columns.set.ofTerm(reading, step) : 0;
  }
  const auto along =
      VectorXd::NullaryExpr(end - begin, [&](Index i) { return columns.reading(begin + i).along; }).eval();
  VectorXd share(columns.count());
  for (Index first = begin, next = begin; first < end; first = next) {
    while (next < end && columns.areOfOneVisit(first, next)) ++next;
    eliminateArcAngle(rows.middleRows(first - begin, next - first),
                      along.segment(first - begin, next - first), share);
  }
}

/// Returns the inner products of the columns after elimination of the arc angles, piece by piece.
MatrixXd reducedGram(const Columns& columns) {
  constexpr Index pieceLength = 4096;
  MatrixXd gram = MatrixXd::Zero(columns.count(), columns.count());
  RowMajorMatrix rows;
  for (Index begin = 0, end = 0; begin < columns.readings(); begin = end) {
    end = std::min(begin + pieceLength, columns.readings());
    while (end < columns.readings() && columns.areOfOneVisit(end - 1, end)) ++end;
    reduce(columns, begin, end, rows);
    gram.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
  }
  return gram.selfadjointView<Eigen::Lower>();
}

}  // namespace

void VisibleTermsOfSet::add(const Linearised& piece) {
  const std::vector<std::size_t> unknowns = piece.uncertainUnknowns();
  const MatrixXd gram = reducedGram({piece, unknowns, m_terms, m_moments});
  if (m_gram.size() == 0) {
    m_gram = gram;
    for (const std::size_t unknown : unknowns) m_priors.push_back(piece.priors[unknown]);
  } else {
    m_gram += gram;
  }
}

VisibleTerms VisibleTermsOfSet::sum() const {
  const auto size = static_cast<Index>(errorTermCount + 2 * m_moments.size());
  VisibleTerms terms{MatrixXd::Zero(size, size), VectorXd::Zero(size)};
  if (m_gram.size() == 0) return terms;
  const auto count = static_cast<Index>(m_priors.size());
  MatrixXd gram = m_gram;
  for (Index u = 0; u < count; ++u) gram(u, u) += m_priors[static_cast<std::size_t>(u)].weight();
  const VectorXd whole = gram.diagonal();
  eliminateFirst(gram, count, whole);
  std::vector<Index> places;  // index of each column among the terms
  for (const ErrorTerm term : m_terms) places.push_back(static_cast<Index>(term));
  for (auto step = static_cast<Index>(errorTermCount); step < size; ++step) places.push_back(step);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Index own = count + static_cast<Index>(i);
    terms.whole[places[i]] = whole[own];
    for (std::size_t j = 0; j < places.size(); ++j)
      terms.gram(places[i], places[j]) = gram(own, count + static_cast<Index>(j));
  }
  return terms;
}

VisibleTerms visibleTerms(const Linearised& set, const std::vector<ErrorTerm>& terms,
                          const std::vector<JumpMoment>& moments) {
  VisibleTermsOfSet sum(terms, moments);
  sum.add(set);
  return sum.sum();
}

VisibleTerms operator+(const VisibleTerms& one, const VisibleTerms& other) {
  return {one.gram + other.gram, one.whole + other.whole};
}

VisibleTerms withEstimated(VisibleTerms terms, const std::vector<EstimatedTerm>& estimated) {
  const auto count = static_cast<Index>(estimated.size()), size = terms.gram.rows();
  if (count == 0) return terms;
  // Puts a copy of each estimated term in front, with its prior; its span is then eliminated.
  MatrixXd chosen = MatrixXd::Zero(size, count + size);
  chosen.rightCols(size).setIdentity();
  for (Index i = 0; i < count; ++i)
    chosen(static_cast<Index>(estimated[static_cast<std::size_t>(i)].term), i) = 1;
  MatrixXd gram = chosen.transpose() * terms.gram * chosen;
  for (Index i = 0; i < count; ++i) gram(i, i) += estimated[static_cast<std::size_t>(i)].prior().weight();
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

double linearDifferenceFrom(const VisibleTerms& terms, const VectorXd& combination, const MatrixXd& columns,
                            Response response) {
  MatrixXd both(combination.size(), columns.cols() + 1);
  both << columns, combination;
  MatrixXd gram = both.transpose() * terms.gram * both;
  const Index own = columns.cols();
  if (response == Response::AllOrNothing) {
    const double trace = gram(own, own), apart = trace - 2 * gram(0, own) + gram(0, 0);
    return std::sqrt(std::max(std::min(trace, apart), 0.0));
  }
  eliminateFirst(gram, own, both.cwiseAbs2().transpose() * terms.whole);
  return std::sqrt(std::max(gram(own, own), 0.0));
}

double linearDifferenceFrom(const VisibleTerms& terms, const VectorXd& combination, const Effect& effect) {
  return linearDifferenceFrom(terms, combination, combinationOf(effect), effect.response);
}

}  // namespace alidade
