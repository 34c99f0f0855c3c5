#include "core/adjustment/gross_errors/gross_error_search.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include "core/adjustment/arc/robust_start.h"
#include "core/adjustment/joint/joint_problem.h"
#include "core/adjustment/joint/reading_test.h"
#include "core/adjustment/numerics/arc_angle_step.h"
#include "core/base/statistics.h"
#include "core/observation/zero_line.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// A reading in the linear theory of the joint fit, whitened.
struct TestedReading {
  ReadingRef cell;
  double sigma = 0;  ///< rad
  std::size_t visit = 0;
  double along = 0;     ///< its component of the unit vector along ∂/∂φ
  double residual = 0;  ///< in σ
};

MatrixXd matrixOf(const SquareMatrix& square) {
  const auto size = static_cast<Index>(square.size);
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      square.values.data(), size, size);
}

/// The projector onto the residuals, entry by entry. After a stop request it has only the first readings.
class Projector {
 public:
  Projector(const Measurement& measurement, const JointFitOptions& options, const JointFit& fit,
            const std::stop_token& stop)
      : m_cofactor(matrixOf(fit.cofactor)) {
    const JointProblem problem(measurement, options);
    const JointState state = problem.stateOf(fit);
    makeRoom(measurement);
    for (std::size_t v = 0; v < problem.visits().size() && !stop.stop_requested(); ++v) {
      const VisitEquations equations = problem.equationsOf(state, v);
      const VisitEquations::Jacobian columns = JointProblem::reduced(equations);
      for (Index row = 0; row < equations.residual.size(); ++row) {
        if (equations.jacobian.row(row).isZero(0)) continue;  // excluded
        const ReadingRef cell = problem.cellOf(v, row);
        m_reduced.col(size()) =
            problem.spread(columns.row(row).transpose(), problem.visits()[v].arc).head(m_cofactor.rows());
        slotOf(cell) = static_cast<std::uint32_t>(size());
        m_readings.push_back({cell, statedSigma(measurement, cell.kind).radians(), v, equations.along[row],
                              equations.residual[row]});
      }
    }
    m_redundancies.resize(size());
    for (std::size_t i = 0; i < m_readings.size(); ++i) m_redundancies[static_cast<Index>(i)] = entry(i, i);
  }

  const std::vector<TestedReading>& readings() const { return m_readings; }

  double operator()(std::size_t i, std::size_t j) const {
    return i == j ? m_redundancies[static_cast<Index>(i)] : entry(i, j);
  }

  /// The index of the reading of the cell; the number of readings if the cell has none.
  std::size_t indexOf(const ReadingRef& cell) const {
    return std::min<std::size_t>(m_slots[cell.arc][slotIn(cell)], m_readings.size());
  }

 private:
  static constexpr std::size_t kinds = 3;
  MatrixXd m_cofactor;
  std::vector<TestedReading> m_readings;
  MatrixXd m_reduced;  ///< ∂reading/∂unknowns, a column for each reading, with the arc angle eliminated
  VectorXd m_redundancies;
  std::vector<std::vector<std::uint32_t>> m_slots;  ///< for each arc: the reading of a cell

  Index size() const { return static_cast<Index>(m_readings.size()); }
  static std::size_t slotIn(const ReadingRef& cell) {
    return kinds * cell.sighting + static_cast<std::size_t>(cell.kind);
  }
  std::uint32_t& slotOf(const ReadingRef& cell) { return m_slots[cell.arc][slotIn(cell)]; }

  void makeRoom(const Measurement& measurement) {
    std::size_t cells = 0;
    for (const ArcMeasurement& arc : measurement.arcs) {
      m_slots.emplace_back(kinds * arc.sightings.size(), std::numeric_limits<std::uint32_t>::max());
      cells += 2 * arc.sightings.size();
      cells += static_cast<std::size_t>(
          std::ranges::count_if(arc.sightings, [](const Sighting& s) { return s.slider.has_value(); }));
    }
    m_readings.reserve(cells);
    m_reduced.resize(m_cofactor.rows(), static_cast<Index>(cells));
  }

  double entry(std::size_t i, std::size_t j) const {
    const TestedReading &a = m_readings[i], &b = m_readings[j];
    const auto ofA = m_reduced.col(static_cast<Index>(i)), ofB = m_reduced.col(static_cast<Index>(j));
    double value = (i == j ? 1 : 0) - ofA.dot(m_cofactor * ofB);
    if (a.visit == b.visit) value -= a.along * b.along;
    return value;
  }
};

class Search {
 public:
  Search(const Measurement& measurement, const GrossErrorOptions& options, const std::stop_token& stop)
      : m_measurement(measurement), m_options(options), m_stop(stop), m_fitOptions(options.fit) {}

  GrossErrorSearch run() {
    start();
    for (std::size_t step = 0; step < 3 * m_options.most + 3; ++step) {
      takeBackInsignificant();
      if (isStopped()) return {};
      if (errorCount() >= m_options.most || !addMostSignificant()) break;
    }
    return isStopped() ? GrossErrorSearch{} : result();
  }

 private:
  struct Shift {
    ReadingRef cell;
    double size = 0;  ///< rad
  };

  /// A sighting that is the only one of its visit. Its two circles give a single condition, its distance from
  /// the arc. The sighting is left out as a whole, and the circle with the smaller error is named.
  struct LeftOut {
    ReadingRef cell, other;
    double size = 0, sigma = 0;  ///< rad; σ scaled by the scatter of the other readings
  };

  bool isStopped() const { return m_stop.stop_requested(); }

  void start() {
    for (std::size_t arc = 0; arc < m_measurement.arcs.size(); ++arc) {
      if (isStopped()) return;
      const RobustStart robust = robustStart(m_measurement, m_measurement.arcs[arc]);
      m_circles.push_back(robust.circle);
      for (const std::size_t row : robust.apart) m_apart.push_back({arc, row, ReadingKind::Horizontal});
      for (const std::size_t row : robust.sliderApart) m_apart.push_back({arc, row, ReadingKind::Slider});
    }
    fitWithoutApart();
    if (m_apart.empty() || isStopped()) return;
    for (const ReadingRef& cell : m_apart) {
      addIfTestable(cell);
      if (cell.kind == ReadingKind::Horizontal)
        addIfTestable({cell.arc, cell.sighting, ReadingKind::Vertical});
    }
    adjust();
  }

  /// Makes a first fit with the deviating rows moved onto the circle of the other rows.
  void fitWithoutApart() {
    m_shifted = m_measurement;
    const bool isKnown =
        m_apart.empty() && m_options.known && m_options.known->converged() && m_fitOptions.without.empty();
    if (isKnown) {
      m_fit = *m_options.known;
      m_projector.emplace(m_shifted, m_fitOptions, m_fit, m_stop);
      return;
    }
    for (const ReadingRef& cell : m_apart) {
      Sighting& sighting = m_shifted.arcs[cell.arc].sightings[cell.sighting];
      if (cell.kind == ReadingKind::Slider) continue;
      const Circle& circle = m_circles[cell.arc];
      const ZeroLine line(m_shifted, m_shifted.arcs[cell.arc]);
      sightPerfectly(sighting, line, circle, nearestArcAngle(circle, line.sightedPoint(sighting)));
    }
    if (isStopped()) return;
    m_fit = fitJointly(m_shifted, m_circles, m_fitOptions);
    m_projector.emplace(m_shifted, m_fitOptions, m_fit, m_stop);
  }

  bool isAlone(const ReadingRef& cell) {
    if (m_alone.empty())
      for (const ArcMeasurement& arc : m_measurement.arcs) m_alone.push_back(rowsAlone(arc));
    return m_alone[cell.arc][cell.sighting];
  }

  /// Rows without a slider reading that are the only ones of their visit.
  static std::vector<bool> rowsAlone(const ArcMeasurement& arc) {
    std::vector<bool> alone(arc.sightings.size());
    for (const Visit& visit : visitsOf(arc))
      if (const std::size_t row = visit.sightings.front(); visit.sightings.size() == 1)
        alone[row] = !arc.sightings[row].slider;
    return alone;
  }

  bool isLeftOut(const ReadingRef& cell) const {
    return std::ranges::any_of(m_leftOut, [&](const LeftOut& out) {
      return out.cell.arc == cell.arc && out.cell.sighting == cell.sighting;
    });
  }

  void take(const ReadingRef& cell) {
    if (!isAlone(cell))
      m_shifts.push_back({cell, 0});
    else if (!isLeftOut(cell))
      m_leftOut.push_back({{cell.arc, cell.sighting, ReadingKind::Horizontal},
                           {cell.arc, cell.sighting, ReadingKind::Vertical}});
  }

  std::size_t errorCount() const { return m_shifts.size() + m_leftOut.size(); }

  /// Measures how far each omitted sighting is from the fitted arc, and chooses the circle to name.
  void measureLeftOut() {
    const JointProblem problem(m_shifted, m_options.fit);
    JointState state = problem.stateOf(m_fit);
    const MatrixXd cofactor = matrixOf(m_fit.cofactor);
    for (LeftOut& out : m_leftOut) {
      const auto visit = std::ranges::find_if(problem.visits(), [&](const VisitOfArc& v) {
        return v.arc == out.cell.arc && v.visit.sightings.front() == out.cell.sighting;
      });
      const auto index = static_cast<std::size_t>(visit - problem.visits().begin());
      VisitEquations equations = problem.equationsOf(state, index);
      for (int iteration = 0; iteration < 30; ++iteration) {
        const double turn = equations.along.dot(equations.residual) / equations.jacobian.col(phiSlot).norm();
        state.arcAngles[static_cast<Index>(index)] += boundedArcAngleStep(turn);
        equations = problem.equationsOf(state, index);
        if (std::abs(turn) < 1e-10) break;
      }
      const Eigen::Vector2d across(-equations.along[1], equations.along[0]);
      const VectorXd reduced =
          (problem.spread(JointProblem::reduced(equations, 0), out.cell.arc) * across[0] +
           problem.spread(JointProblem::reduced(equations, 1), out.cell.arc) * across[1])
              .head(cofactor.rows());
      const Index larger = std::abs(across[0]) >= std::abs(across[1]) ? 0 : 1;
      if ((larger == 0) != (out.cell.kind == ReadingKind::Horizontal)) std::swap(out.cell, out.other);
      const double unit = statedSigma(m_measurement, out.cell.kind).radians() / across[larger];
      out.size = (across[0] * equations.residual[0] + across[1] * equations.residual[1]) * unit;
      out.sigma = scale() * std::sqrt(1 + reduced.dot(cofactor * reduced)) * std::abs(unit);
    }
  }

  std::vector<std::size_t> foundCells() const {
    std::vector<std::size_t> indices;
    for (const Shift& shift : m_shifts) indices.push_back(m_projector->indexOf(shift.cell));
    return indices;
  }

  MatrixXd foundProjector(const std::vector<std::size_t>& cells) const {
    MatrixXd matrix(static_cast<Index>(cells.size()), static_cast<Index>(cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (std::size_t j = 0; j < cells.size(); ++j)
        matrix(static_cast<Index>(i), static_cast<Index>(j)) = (*m_projector)(cells[i], cells[j]);
    return matrix;
  }

  /// The share of an error of reading `k` that its residual shows while the shifts of `cells` are free.
  double remainingRedundancy(const std::vector<std::size_t>& cells, const MatrixXd& inverse,
                             std::size_t k) const {
    VectorXd cross(static_cast<Index>(cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) cross[static_cast<Index>(i)] = (*m_projector)(cells[i], k);
    return (*m_projector)(k, k) - cross.dot(inverse * cross);
  }

  void addIfTestable(const ReadingRef& cell) {
    const std::size_t k = m_projector->indexOf(cell);
    if (k == m_projector->readings().size()) return;
    if (static_cast<int>(errorCount()) + 2 > m_fit.degreesOfFreedom || m_shifts.size() >= m_options.most)
      return;
    const std::vector<std::size_t> cells = foundCells();
    if (remainingRedundancy(cells, foundProjector(cells).inverse(), k) < ReadingTest::leastRedundancy) return;
    take(cell);
  }

  /// Adjusts fit and shifts together: Gauss-Newton on the shifts, with a new fit for each step.
  void adjust() {
    m_fitOptions.without = m_options.fit.without;
    for (const LeftOut& out : m_leftOut) {
      m_fitOptions.without.push_back(out.cell);
      m_fitOptions.without.push_back(out.other);
    }
    adjustShifts();
    if (!isStopped()) measureLeftOut();
  }

  void adjustShifts() {
    for (int iteration = 0; iteration < 8; ++iteration) {
      m_shifted = m_measurement;
      for (const Shift& shift : m_shifts) shiftReading(m_shifted, shift.cell, Angle::fromRadians(shift.size));
      m_fit = fitJointly(m_shifted, m_circles, m_fitOptions);
      startFromFit();
      m_projector.emplace(m_shifted, m_fitOptions, m_fit, m_stop);
      if (isStopped()) return;
      // After divergence, a reading may not depend on any unknown.
      std::erase_if(m_shifts, [&](const Shift& shift) {
        return m_projector->indexOf(shift.cell) == m_projector->readings().size();
      });
      const std::vector<std::size_t> cells = foundCells();
      m_inverse = foundProjector(cells).inverse();
      VectorXd residual(static_cast<Index>(cells.size()));
      for (std::size_t i = 0; i < cells.size(); ++i)
        residual[static_cast<Index>(i)] = m_projector->readings()[cells[i]].residual;
      const VectorXd step = m_inverse * residual;
      if (!(step.dot(residual) > 1e-6)) break;
      for (std::size_t i = 0; i < cells.size(); ++i)
        m_shifts[i].size += step[static_cast<Index>(i)] * m_projector->readings()[cells[i]].sigma;
    }
  }

  /// Makes the next fit start from the circles of the last fit.
  void startFromFit() {
    if (!m_fit.converged()) return;
    for (std::size_t arc = 0; arc < m_circles.size(); ++arc) m_circles[arc] = m_fit.circleOf(arc);
  }

  int freedom() const { return m_fit.degreesOfFreedom - static_cast<int>(m_shifts.size()); }

  /// Critical value of |t| with `freedom` degrees of freedom.
  double critical(int freedom) const {
    return ReadingTest{.risk = m_options.risk,
                       .tests = differentTests(m_fit.readings) + static_cast<int>(m_leftOut.size()),
                       .degreesOfFreedom = freedom}
        .criticalValue();
  }

  void takeBackInsignificant() {
    while (errorCount() > 0 && !isStopped()) {
      std::size_t weakest = 0;
      for (std::size_t i = 1; i < errorCount(); ++i)
        if (std::abs(studentised(i)) < std::abs(studentised(weakest))) weakest = i;
      if (freedom() >= 1 && std::abs(studentised(weakest)) >= critical(freedom())) return;
      if (weakest < m_shifts.size())
        m_shifts.erase(m_shifts.begin() + static_cast<std::ptrdiff_t>(weakest));
      else
        m_leftOut.erase(m_leftOut.begin() + static_cast<std::ptrdiff_t>(weakest - m_shifts.size()));
      adjust();
    }
  }

  double scale() const { return freedom() > 0 ? std::sqrt(m_fit.chiSquare / freedom()) : 1; }

  double sigmaOfShift(std::size_t i) const {
    return scale() * std::sqrt(m_inverse(static_cast<Index>(i), static_cast<Index>(i))) *
           statedSigma(m_measurement, m_shifts[i].cell.kind).radians();
  }

  /// Returns t of entry i: first the shifts, then the omitted sightings.
  double studentised(std::size_t i) const {
    if (i < m_shifts.size()) return m_shifts[i].size / sigmaOfShift(i);
    const LeftOut& out = m_leftOut[i - m_shifts.size()];
    return out.size / out.sigma;
  }

  bool addMostSignificant() {
    const int left = freedom() - 1;
    if (left < 1) return false;
    const std::vector<std::size_t> cells = foundCells();
    const auto& readings = m_projector->readings();
    double most = 0;
    std::size_t best = readings.size();
    for (std::size_t k = 0; k < readings.size(); ++k) {
      if (std::ranges::find(cells, k) != cells.end()) continue;
      const double redundancy = remainingRedundancy(cells, m_inverse, k);
      if (redundancy < ReadingTest::leastRedundancy) continue;
      const double drop = readings[k].residual * readings[k].residual / redundancy;
      if (drop <= most) continue;
      most = drop;
      best = k;
    }
    if (best == readings.size()) return false;
    const double others = std::max(m_fit.chiSquare - most, 1e-12 * m_fit.chiSquare) / left;
    if (most < others * std::pow(critical(left), 2)) return false;
    take(readings[best].cell);
    adjust();
    return true;
  }

  /// Readings of the visit whose shift reduces χ² nearly as much as shift `i`.
  std::vector<ReadingRef> rivalsOf(std::size_t i) const {
    std::vector<std::size_t> others = foundCells();
    const std::size_t self = others[i];
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const MatrixXd inverse = foundProjector(others).inverse();
    const auto& readings = m_projector->readings();
    const double own = remainingRedundancy(others, inverse, self);
    const double size = m_shifts[i].size / readings[self].sigma;
    std::vector<ReadingRef> rivals;
    for (std::size_t k = 0; k < readings.size(); ++k) {
      if (k == self || readings[k].visit != readings[self].visit ||
          std::ranges::find(others, k) != others.end())
        continue;
      const double redundancy = remainingRedundancy(others, inverse, k);
      if (redundancy < ReadingTest::leastRedundancy) continue;
      VectorXd a(inverse.rows()), b(inverse.rows());
      for (std::size_t j = 0; j < others.size(); ++j) {
        a[static_cast<Index>(j)] = (*m_projector)(others[j], self);
        b[static_cast<Index>(j)] = (*m_projector)(others[j], k);
      }
      const double cross = (*m_projector)(self, k) - a.dot(inverse * b);
      const double lost = size * size * (own - cross * cross / redundancy);
      if (lost < 9 * scale() * scale()) rivals.push_back(readings[k].cell);
    }
    return rivals;
  }

  GrossErrorSearch result() const {
    GrossErrorSearch search;
    for (std::size_t i = 0; i < m_shifts.size(); ++i)
      search.grossErrors.push_back({m_shifts[i].cell, Angle::fromRadians(m_shifts[i].size),
                                    Angle::fromRadians(sigmaOfShift(i)), studentised(i), rivalsOf(i)});
    for (std::size_t i = 0; i < m_leftOut.size(); ++i) {
      const LeftOut& out = m_leftOut[i];
      search.grossErrors.push_back({out.cell,
                                    Angle::fromRadians(out.size),
                                    Angle::fromRadians(out.sigma),
                                    studentised(m_shifts.size() + i),
                                    {out.other}});
    }
    for (GrossError& error : search.grossErrors) {  // half a turn may be fitted in either direction
      const bool isWithinTurn = std::abs(error.size.radians()) < 2 * std::numbers::pi;
      if (error.cell.kind == ReadingKind::Slider && isWithinTurn) error.size = wrapped(error.size);
    }
    // Errors of a reading are at most half a turn: a larger size means that the fit diverged.
    std::erase_if(search.grossErrors, [](const GrossError& error) {
      return !(std::abs(error.size.radians()) <= std::numbers::pi);
    });
    std::ranges::sort(search.grossErrors, std::ranges::greater(),
                      [](const GrossError& m) { return std::abs(m.studentised); });
    if (search.grossErrors.size() > m_options.most) search.grossErrors.resize(m_options.most);
    for (const LeftOut& out : m_leftOut) {
      search.leftOut.push_back(out.cell);
      search.leftOut.push_back(out.other);
    }
    search.fit = m_fit;
    search.noiseFactor = scale();
    search.degreesOfFreedom = freedom();
    if (freedom() > 1) search.criticalValue = critical(freedom());
    return search;
  }

  const Measurement& m_measurement;
  const GrossErrorOptions& m_options;
  const std::stop_token& m_stop;
  JointFitOptions m_fitOptions;
  std::vector<Circle> m_circles;
  std::vector<ReadingRef> m_apart;
  std::vector<std::vector<bool>> m_alone;  ///< for each arc, computed when needed
  std::vector<Shift> m_shifts;
  std::vector<LeftOut> m_leftOut;
  Measurement m_shifted;
  JointFit m_fit;
  std::optional<Projector> m_projector;
  MatrixXd m_inverse;
};

}  // namespace

GrossErrorSearch searchGrossErrors(const Measurement& measurement, const GrossErrorOptions& options,
                                   const std::stop_token& stop) {
  return Search(measurement, options, stop).run();
}

void shiftReading(Measurement& measurement, const ReadingRef& cell, Angle size) {
  Sighting& sighting = measurement.arcs[cell.arc].sightings[cell.sighting];
  if (cell.kind == ReadingKind::Horizontal) sighting.a = sighting.a - size;
  if (cell.kind == ReadingKind::Vertical) sighting.e = sighting.e - size;
  if (cell.kind == ReadingKind::Slider) sighting.slider = *sighting.slider - size;
}

}  // namespace alidade
