#include "core/adjustment/joint/fast_joint_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/adjustment/arc/visit_feet.h"
#include "core/base/threads.h"
#include "core/observation/half_turn.h"
#include "core/observation/slider_turns.h"
#include "core/observation/visits.h"
#include "core/observation/zero_line.h"

namespace alidade {

namespace {

using Kind = Unknown::Kind;
using Eigen::Matrix4d, Eigen::Vector4d;

/// The unknowns of one arc. Without slider readings the slider's zero stays fixed.
constexpr std::array estimatedKinds{Kind::CentreX, Kind::CentreY, Kind::Radius, Kind::SliderZero};
constexpr std::array consideredKinds{Kind::HorizontalZero, Kind::VerticalZero, Kind::Distance};
constexpr int estimatedCount = estimatedKinds.size(), consideredCount = consideredKinds.size();
static_assert(estimatedCount == ArcEquations::estimated && consideredCount == ArcEquations::considered);
using NormalMatrix = Eigen::Matrix<double, estimatedCount, ArcEquations::columns, Eigen::RowMajor>;

/// The inverse. The matrix is first scaled to a unit diagonal: millimetres and radians differ by 1e6 in size.
Matrix4d cofactorMatrix(const Matrix4d& matrix) {
  const Vector4d scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
  const Matrix4d scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
  const Matrix4d inverse = scaled.ldlt().solve(Matrix4d::Identity());
  return scale.asDiagonal() * ((inverse + inverse.transpose()) / 2) * scale.asDiagonal();
}

class ArcApart {
 public:
  ArcApart(const Measurement& measurement, std::size_t index, const Circle& start)
      : m_measurement(measurement),
        m_index(index),
        m_arc(measurement.arcs[index]),
        m_line(measurement, m_arc),
        m_feet(ArcView(measurement, m_arc.axisDeg)),
        m_unknowns{start} {
    m_unknowns.circle.y += m_line.height();
  }

  /// Returns false if the fit is refused. Must be called once, before all other methods.
  bool converge(const JointFitOptions& options) {
    readVisits();
    constexpr int mostIterations = 10;
    constexpr double longest = 0.1;  // of R; limit of each step
    constexpr double rounding = 1e-9;
    for (double before = std::numeric_limits<double>::infinity();; before = m_chiSquare) {
      evaluate();
      ++m_iterations;
      if (!(m_chiSquare <= before + rounding * (1 + before))) return false;
      m_cofactor = cofactorMatrix(m_normal.leftCols<estimatedCount>());
      const Vector4d step = m_cofactor * m_right;
      if (!step.allFinite() || !(m_cofactor.diagonal().array() >= 0).all()) return false;
      if (m_right.dot(step) < options.tolerance * options.tolerance) return true;
      if (m_iterations == mostIterations || step.head<3>().norm() > longest * m_unknowns.circle.radius)
        return false;
      m_unknowns.circle.x += step[0];
      m_unknowns.circle.y += step[1];
      m_unknowns.circle.radius += step[2];
      if (m_hasSlider) m_unknowns.sliderZero += step[3];
    }
  }

  int iterations() const { return m_iterations; }
  int unknowns() const { return m_hasSlider ? estimatedCount : estimatedCount - 1; }
  std::size_t readings() const {
    const auto isRead = [](const Sighting* slider) { return slider != nullptr; };
    return 2 * m_arc.sightings.size() + static_cast<std::size_t>(std::ranges::count_if(m_sliders, isRead));
  }
  const Matrix4d& cofactor() const { return m_cofactor; }

  /// ∂estimated/∂considered.
  Eigen::Matrix<double, estimatedCount, consideredCount> perConsidered() const {
    Eigen::Matrix<double, estimatedCount, consideredCount> rates =
        -m_cofactor * m_normal.middleCols<consideredCount>(estimatedCount);
    // The kernel counts y from the horizon, but results count from the line of the zero.
    const double cosine = std::cos(m_line.elevation());
    rates.col(1) << 0, -m_measurement.distance / (cosine * cosine), 0, 0;
    rates(1, 2) -= std::tan(m_line.elevation());
    return rates;
  }

  Vector4d values() const {
    const double zero = wrapped(Angle::fromRadians(m_unknowns.sliderZero)).radians();
    return {m_unknowns.circle.x, m_unknowns.circle.y - m_line.height(), m_unknowns.circle.radius, zero};
  }

  /// Fills in the arc's own values in `fit`, which has room for all arcs, and the arc's readings from `next`
  /// on. `gradient`: ∂Δd/∂y of the centre.
  void fillReadings(JointFit& fit, AdjustedReading* next, double gradient) const {
    const auto sigmaOf = [&](ReadingKind kind) { return statedSigma(m_measurement, kind).radians(); };
    const std::array sigmas{sigmaOf(ReadingKind::Horizontal), sigmaOf(ReadingKind::Vertical),
                            sigmaOf(ReadingKind::Slider)};
    const Whitening& whitening = m_feet.view().whitening;
    VisitFeet::Cofactor cofactor;
    std::array<double, estimatedCount> perUnknown{};
    Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(cofactor.front().data()) = m_cofactor;
    Eigen::Map<Vector4d>(perUnknown.data()) = gradient * m_cofactor.col(1);
    std::vector<double>& angles = fit.arcAngles[m_index];
    angles.resize(m_arc.sightings.size());
    ArcResidualSum sum{0, -static_cast<double>(m_visits.size()) - unknowns()};
    std::array<VisitReliability, eight> reliability;
    const std::vector<double> arcAngles = unwrappedArcAngles();
    for (std::size_t v = 0; v < m_visits.size(); ++v) {
      if (v % eight == 0) reliability = m_feet.reliabilityOf(v / eight, cofactor, perUnknown);
      const VisitReliability& own = reliability[v % eight];
      const auto add = [&](std::size_t sighting, ReadingKind kind, double residual, double perReading) {
        const auto row = static_cast<std::size_t>(kind);
        const double rate = own.rate[row] * perReading;
        const auto visit = static_cast<std::uint32_t>(v);
        const double redundancy = std::clamp(own.redundancy[row], 0.0, 1.0);  // rounding may exceed 0…1
        *next++ = {m_index, sighting, kind, visit, residual, sigmas[row], redundancy, rate};
        sum.chiSquare += residual * perReading * residual * perReading;
        ++sum.degreesOfFreedom;
      };
      const Direction<double>& mean = m_visits[v].mean.direction;
      const Direction<double> left = m_feet.left(v);
      for (const std::size_t i : m_visits[v].sightings) {
        const Sighting& row = m_arc.sightings[i];
        angles[i] = arcAngles[v];
        add(i, ReadingKind::Horizontal, row.a.radians() - mean.a + left.a, whitening.horizontal);
        add(i, ReadingKind::Vertical, row.e.radians() - mean.e + left.e, whitening.vertical);
      }
      if (m_sliders[v])
        add(static_cast<std::size_t>(m_sliders[v] - m_arc.sightings.data()), ReadingKind::Slider,
            m_feet.sliderLeft(v), whitening.slider);
    }
    fit.residualSums[m_index] = sum;
  }

 private:
  std::vector<double> unwrappedArcAngles() const {
    std::vector<double> arcAngles(m_visits.size());
    for (std::size_t v = 0; v < m_visits.size(); ++v)
      arcAngles[v] = unwrappedArcAngle(m_feet.arcAngle(v), m_arc.axisDeg);
    if (m_hasSlider) unwrapAlongSlider(arcAngles, m_sliders, m_arc.axisDeg);
    return arcAngles;
  }

  void readVisits() {
    m_visits = visitsOf(m_arc);
    m_feet.reserve(m_visits.size());
    m_sliders.reserve(m_visits.size());
    const std::size_t step = 1 + m_visits.size() / 8;  // about eight visits give the start well enough
    MeanDirection zero;
    for (std::size_t v = 0; v < m_visits.size(); ++v) {
      const Visit& visit = m_visits[v];
      VisitReading reading(m_line.levelled(visit.mean.direction), visit.mean.rows);
      if (const Sighting* row = m_sliders.emplace_back(sliderOf(m_arc, visit))) {
        reading.slider = row->slider->radians();
        if (!m_hasSlider || v % step == 0) zero.add(sliderZeroBy(reading));
        m_hasSlider = true;
      }
      m_feet.add(reading);
    }
    m_unknowns.sliderZero = zero.value().radians();
  }

  Angle sliderZeroBy(const VisitReading& reading) const {
    const PlanePoint<double> place = sightedPoint(m_feet.view(), reading);
    return Angle::fromRadians(*reading.slider -
                              m_feet.view().turn * nearestArcAngle(m_unknowns.circle, place));
  }

  /// Computes feet, normal equations and χ², which omits the differences between rows of a visit.
  void evaluate() {
    const bool isFirst = m_iterations == 0;
    const ArcEquations equations =
        m_feet.converge(m_unknowns, isFirst ? VisitFeet::From::Plane : VisitFeet::From::Before);
    m_normal = Eigen::Map<const NormalMatrix>(equations.normal.front().data());
    m_right = Eigen::Map<const Vector4d>(equations.rightSide.data());
    m_chiSquare = equations.chiSquare;
    if (!m_hasSlider) m_normal(3, 3) = 1;
  }

  const Measurement& m_measurement;
  std::size_t m_index;
  const ArcMeasurement& m_arc;
  std::vector<Visit> m_visits;
  ZeroLine m_line;
  VisitFeet m_feet;
  std::vector<const Sighting*> m_sliders;
  bool m_hasSlider = false;
  ArcUnknowns m_unknowns;
  NormalMatrix m_normal;
  Vector4d m_right;
  Matrix4d m_cofactor;
  double m_chiSquare = 0;
  int m_iterations = 0;
};

void addUnknowns(JointFit& fit, const std::vector<ArcApart>& arcs) {
  const std::size_t most = estimatedCount * arcs.size();
  fit.firsts.reserve(arcs.size());
  fit.unknowns.reserve(most);
  fit.values.reserve(most);
  fit.priorSigmas.reserve(most);
  for (std::size_t arc = 0; arc < arcs.size(); ++arc) {
    fit.firsts.push_back(arc);
    const Vector4d values = arcs[arc].values();
    for (int i = 0; i < arcs[arc].unknowns(); ++i) {
      fit.unknowns.push_back({.kind = estimatedKinds[static_cast<std::size_t>(i)], .arc = arc});
      fit.values.push_back(values[i]);
      fit.priorSigmas.push_back(std::numeric_limits<double>::infinity());
    }
  }
}

void addConsidered(JointFit& fit, const Measurement& measurement) {
  fit.zerosAreReadings = measurement.zerosAreReadings;
  fit.zeroScatter = measurement.zeroScatter;
  const std::size_t zeros = measurement.hasOneZero() ? 1 : measurement.arcs.size();
  fit.considered.reserve(2 * zeros + 1);
  fit.consideredSigmas.reserve(2 * zeros + 1);
  for (std::size_t zero = 0; zero < zeros; ++zero) {
    const std::size_t arc = measurement.hasOneZero() ? Unknown::everyArc : zero;
    fit.considered.push_back({.kind = Kind::HorizontalZero, .arc = arc});
    fit.considered.push_back({.kind = Kind::VerticalZero, .arc = arc});
    fit.consideredSigmas.push_back(measurement.sigmaOfZeroHorizontal(measurement.arcs[zero]).radians());
    fit.consideredSigmas.push_back(measurement.sigmaOfZeroVertical(measurement.arcs[zero]).radians());
  }
  fit.considered.push_back({.kind = Kind::Distance});
  fit.consideredSigmas.push_back(measurement.sigmaDistance);
}

/// Combines the matrices of the arcs, which share only the distance and a common zero.
void fillMatrices(JointFit& fit, const std::vector<ArcApart>& arcs) {
  const std::size_t size = fit.unknowns.size(), width = fit.considered.size();
  fit.cofactor = {size, std::vector<double>(size * size)};
  fit.perConsidered.assign(size * width, 0);
  std::size_t first = 0;
  for (std::size_t arc = 0; arc < arcs.size(); ++arc) {
    const Matrix4d& cofactor = arcs[arc].cofactor();
    const auto perConsidered = arcs[arc].perConsidered();
    const auto count = static_cast<std::size_t>(arcs[arc].unknowns());
    for (std::size_t i = 0; i < count; ++i) {
      const auto row = static_cast<int>(i);
      for (std::size_t j = 0; j < count; ++j)
        fit.cofactor.values[(first + i) * size + first + j] = cofactor(row, static_cast<int>(j));
      double* rates = &fit.perConsidered[(first + i) * width];
      const std::size_t zero = fit.considered.front().arc == Unknown::everyArc ? 0 : 2 * arc;
      rates[zero] = perConsidered(row, 0);
      rates[zero + 1] = perConsidered(row, 1);
      rates[width - 1] = perConsidered(row, 2);
    }
    first += count;
  }
  fit.cofactorWithoutTerms = fit.cofactor;
}

bool isUsualCase(const Measurement& measurement, const JointFitOptions& options) {
  const auto isLevelExact = [&](const ArcMeasurement& arc) {
    return ZeroLine(measurement, arc).isLevelExact();
  };
  return measurement.radiusModel == RadiusModel::Free &&
         std::ranges::all_of(measurement.arcs, isLevelExact) && options.terms.empty() &&
         options.without.empty() && !options.isClosed && !options.estimatesZeros &&
         (options.isApart || !hasRepeats(measurement));
}

}  // namespace

std::optional<JointFit> fitJointlyFast(const Measurement& measurement, const std::vector<Circle>& starts,
                                       const JointFitOptions& options) {
  assert(starts.size() == measurement.arcs.size());
  if (!isUsualCase(measurement, options)) return std::nullopt;
  const std::size_t threads = threadsFor(measurement.rows);
  std::vector<ArcApart> arcs;
  arcs.reserve(starts.size());
  std::vector<char> converged(starts.size());
  for (std::size_t i = 0; i < starts.size(); ++i) arcs.emplace_back(measurement, i, starts[i]);
  doEach(threads, arcs.size(), [&](std::size_t i) { converged[i] = arcs[i].converge(options) ? 1 : 0; });
  if (std::ranges::find(converged, 0) != converged.end()) return std::nullopt;
  JointFit fit;
  addUnknowns(fit, arcs);
  addConsidered(fit, measurement);
  fillMatrices(fit, arcs);
  std::vector<std::size_t> firsts;  // index of the first reading of each arc
  std::size_t readings = 0;
  for (const ArcApart& arc : arcs) {
    firsts.push_back(readings);
    readings += arc.readings();
  }
  fit.readings.resize(readings);
  fit.arcAngles.resize(arcs.size());
  fit.residualSums.resize(arcs.size());
  const bool hasIntersection = hasBothAxes(measurement) && !hasRepeats(measurement);
  doEach(threads, arcs.size(), [&](std::size_t i) {
    const double perHeight = intersectionPerHeight(measurement.arcs[i].axisDeg);
    arcs[i].fillReadings(fit, fit.readings.data() + firsts[i], hasIntersection ? perHeight : 0);
  });
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    fit.iterations = std::max(fit.iterations, arcs[i].iterations());
    fit.chiSquare += fit.residualSums[i].chiSquare;
    fit.degreesOfFreedom += static_cast<int>(fit.residualSums[i].degreesOfFreedom);
  }
  fit.status = FitStatus::Converged;
  return fit;
}

}  // namespace alidade
