#include "core/diagnosis/gap/held_out.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/adjustment/numerics/arc_angle_elimination.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr std::size_t folds = 5;

struct Row {
  std::size_t fold = folds;  ///< `folds` for a row in no fold (prior knowledge or pointing zero)
  double arcseconds = 0;     ///< σ of the reading; 0 for a row that does not count
};

/// The whitened equations at the solution of a fit, after elimination of the arc angles: rows of readings,
/// then of prior knowledge. A reading alone in its visit carries no information and has no row.
struct Equations {
  MatrixXd columns;
  VectorXd observed;
  std::vector<Row> rows;
};

/// Adds the rows of one visit, readings [first, end), after elimination of its arc angle.
void addVisit(Equations& equations, const Linearised& set, const MatrixXd& columns, std::size_t first,
              std::size_t end) {
  std::vector<std::size_t> taking;
  for (std::size_t i = first; i < end; ++i)
    if (set.readings[i].takesPart) taking.push_back(i);
  if (taking.size() < 2) return;
  const std::ptrdiff_t count = std::ssize(taking);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> own(count, columns.cols() + 1);
  VectorXd along(count), share(columns.cols() + 1);
  for (Index i = 0; i < count; ++i) {
    const std::size_t reading = taking[static_cast<std::size_t>(i)];
    own.row(i) << columns.row(static_cast<Index>(reading)), set.readings[reading].residual;
    along[i] = set.readings[reading].along;
  }
  eliminateArcAngle(own, along, share);
  const auto next = static_cast<Index>(equations.rows.size());
  equations.columns.middleRows(next, count) = own.leftCols(columns.cols());
  equations.observed.segment(next, count) = own.col(columns.cols());
  for (const std::size_t i : taking) {
    const LinearReading& reading = set.readings[i];
    const bool counts = reading.kind != ReadingKind::Slider && !reading.isZero;
    equations.rows.push_back({reading.isZero ? folds : reading.visit % folds,
                              counts ? Angle::fromRadians(reading.sigma).arcseconds() : 0});
  }
}

Equations equationsOf(const GapModel& model) {
  const Linearised set = linearise(*model.measurement, *model.fit, model.options, {});
  std::vector<std::size_t> estimated;
  for (std::size_t u = 0; u < set.unknowns.size(); ++u)
    if (model.fit->indexOf(set.unknowns[u]) < model.fit->unknowns.size()) estimated.push_back(u);
  const std::vector<EstimatedTerm>& terms = model.options.terms;
  const auto readings = static_cast<Index>(set.readings.size()),
             count = static_cast<Index>(estimated.size() + terms.size());
  MatrixXd columns(readings, count);
  for (Index i = 0; i < readings; ++i) {
    Index column = 0;
    for (const std::size_t u : estimated)
      columns(i, column++) = set.ofUnknown(static_cast<std::size_t>(i), u);
    for (const EstimatedTerm& term : terms)
      columns(i, column++) = set.ofTerm(static_cast<std::size_t>(i), term.term);
  }
  Equations equations{MatrixXd::Zero(readings + count, count), VectorXd::Zero(readings + count), {}};
  for (std::size_t first = 0, end = 0; first < set.readings.size(); first = end) {
    while (end < set.readings.size() && set.readings[end].visit == set.readings[first].visit) ++end;
    addVisit(equations, set, columns, first, end);
  }
  for (const PriorRow& prior : set.priorRows(estimated, terms)) {
    const auto row = static_cast<Index>(equations.rows.size());
    equations.columns(row, static_cast<Index>(prior.column)) = prior.derivative;
    equations.observed[row] = prior.residual;
    equations.rows.push_back({});
  }
  const auto rows = static_cast<Index>(equations.rows.size());
  equations.columns.conservativeResize(rows, Eigen::NoChange);
  equations.observed.conservativeResize(rows);
  const VectorXd scale = equations.columns.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  equations.columns *= scale.asDiagonal();
  return equations;
}

struct Squares {
  double sum = 0;  ///< arcseconds²
  int count = 0;

  void add(const Squares& other) {
    sum += other.sum;
    count += other.count;
  }
};

/// The normal equations of each fold, followed by those of prior knowledge and pointing zeros.
class Folds {
 public:
  explicit Folds(Equations equations) : m_equations(std::move(equations)) {
    const Index count = m_equations.columns.cols();
    m_sums.fill({MatrixXd::Zero(count, count), VectorXd::Zero(count)});
    for (std::size_t i = 0; i < m_equations.rows.size(); ++i) {
      const auto row = m_equations.columns.row(static_cast<Index>(i));
      Normal& sum = m_sums[m_equations.rows[i].fold];
      sum.matrix.noalias() += row.transpose().lazyProduct(row);
      sum.right.noalias() += row.transpose() * m_equations.observed[static_cast<Index>(i)];
    }
  }

  /// Returns the squared errors of the prediction of a fold from the other folds. Absent if the other folds
  /// do not determine the unknowns.
  std::optional<Squares> predicted(std::size_t fold) const {
    constexpr double determined = 1e-13;  // square of the part of a column orthogonal to the other columns
    Normal others = m_sums[folds];
    for (std::size_t f = 0; f < folds; ++f)
      if (f != fold) {
        others.matrix += m_sums[f].matrix;
        others.right += m_sums[f].right;
      }
    const Eigen::LDLT<MatrixXd> factor(others.matrix);
    if (factor.vectorD().size() > 0 && factor.vectorD().minCoeff() < determined) return std::nullopt;
    const VectorXd solution = factor.solve(others.right);
    Squares squares;
    for (std::size_t i = 0; i < m_equations.rows.size(); ++i) {
      const Row& row = m_equations.rows[i];
      if (row.fold != fold || row.arcseconds == 0) continue;
      const auto at = static_cast<Index>(i);
      const double error = m_equations.observed[at] - m_equations.columns.row(at).dot(solution);
      squares.sum += std::pow(error * row.arcseconds, 2);
      ++squares.count;
    }
    return squares;
  }

 private:
  struct Normal {
    MatrixXd matrix;
    VectorXd right;
  };
  Equations m_equations;
  std::array<Normal, folds + 1> m_sums;
};

}  // namespace

double heldOutShrinkage(const GapModel& before, const GapModel& after) {
  const Folds first(equationsOf(before)), second(equationsOf(after));
  Squares ofFirst, ofSecond;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    const std::optional<Squares> one = first.predicted(fold), other = second.predicted(fold);
    if (!one || !other) continue;
    ofFirst.add(*one);
    ofSecond.add(*other);
  }
  if (ofFirst.sum == 0 || ofSecond.count == 0) return std::numeric_limits<double>::quiet_NaN();
  return 1 - std::sqrt(ofSecond.sum / ofSecond.count) / std::sqrt(ofFirst.sum / ofFirst.count);
}

}  // namespace alidade
