#include <algorithm>
#include <cmath>

#include "core/adjustment/arc/arc_checks.h"
#include "core/adjustment/arc/fast_arc_fit.h"
#include "core/adjustment/monte_carlo/refit.h"
#include "core/observation/visits.h"
#include "core/observation/zero_line.h"

namespace alidade {

bool haveNothingInCommon(const Measurement& fitted) {
  const auto isLevelExact = [&](const ArcMeasurement& arc) { return ZeroLine(fitted, arc).isLevelExact(); };
  return estimatedTerms(fitted).empty() && std::ranges::all_of(fitted.arcs, isLevelExact) &&
         !hasRepeats(fitted) && fitted.radiusModel == RadiusModel::Free &&
         std::ranges::none_of(fitted.arcs, hasSliderReadings);
}

namespace {

/// The readings of an arc, visit by visit. All visits have the same number of rows.
struct VisitColumns {
  std::vector<double> a, e;        ///< rad
  std::vector<std::size_t> noise;  ///< index of each row's noise in a draw
  int rows = 0;                    ///< in each visit

  VisitColumns(const RefitTask& task, std::size_t arc) {
    const ZeroLine line(task.fitted, task.fitted.arcs[arc]);
    for (const Visit& visit : visitsOf(task.fitted.arcs[arc])) {
      const Direction<double> level = line.levelled(visit.mean.direction);
      a.push_back(level.a);
      e.push_back(level.e);
      for (const std::size_t sighting : visit.sightings) noise.push_back(task.plan.readings(arc, sighting));
      rows = visit.mean.rows;
    }
  }
};

class ArcsRefit : public Refit {
 public:
  explicit ArcsRefit(const RefitTask& task) : m_task(task), m_general(generalRefit(task)) {
    for (std::size_t arc = 0; arc < task.fitted.arcs.size(); ++arc) m_arcs.emplace_back(task, arc);
  }

  static bool serves(const RefitTask& task) {
    return haveNothingInCommon(task.fitted) &&
           std::ranges::all_of(task.fitted.arcs, [](const ArcMeasurement& arc) {
             const std::vector<Visit> visits = visitsOf(arc);
             return std::ranges::all_of(
                 visits, [&](const Visit& visit) { return visit.mean.rows == visits.front().mean.rows; });
           });
  }

  void refit(std::span<const Draw> draws, std::span<double> centres) override {
    for (std::size_t arc = 0; arc < m_arcs.size(); ++arc) refitArc(arc, draws, centres);
    for (std::size_t i = 0; i < draws.size(); ++i) {
      const auto own = centres.subspan(i * m_task.centres(), m_task.centres());
      if (std::ranges::any_of(own, [](double value) { return std::isnan(value); }))
        m_general->refit(draws.subspan(i, 1), own);
    }
  }

 private:
  /// Fills the mean readings of every visit plus their drawn noise. The noise of the horizontal zero is the
  /// same for all a; `refitArc` adds the noise of the vertical zero.
  void takeReadings(std::size_t arc, std::span<const Draw> draws) {
    const Measurement& read = m_task.fitted;
    const VisitColumns& visits = m_arcs[arc];
    m_a.resize(draws.size() * visits.a.size());
    m_e.resize(m_a.size());
    const double sigmaA = read.sigmaHorizontal.radians(), sigmaE = read.sigmaVertical.radians(),
                 sigmaZeroA = read.sigmaOfZeroHorizontal(read.arcs[arc]).radians();
    std::size_t next = 0;
    for (const Draw& draw : draws) {
      const double* zeros = &draw.normals[m_task.plan.zeros(arc)];
      const double zeroA = sigmaZeroA * draw.zeroScale * zeros[0];
      const double perRow = draw.scale / visits.rows;
      const std::size_t* noiseAt = visits.noise.data();
      for (std::size_t visit = 0; visit < visits.a.size(); ++visit, ++next) {
        double noiseA = 0, noiseE = 0;
        for (int row = 0; row < visits.rows; ++row, ++noiseAt) {
          noiseA += draw.normals[*noiseAt];
          noiseE += draw.normals[*noiseAt + 1];
        }
        m_a[next] = visits.a[visit] + zeroA + sigmaA * perRow * noiseA;
        m_e[next] = visits.e[visit] + sigmaE * perRow * noiseE;
      }
    }
  }

  void refitArc(std::size_t arc, std::span<const Draw> draws, std::span<double> centres) {
    takeReadings(arc, draws);
    const Measurement& read = m_task.fitted;
    const double perRoot = 1 / std::sqrt(static_cast<double>(m_arcs[arc].rows));
    const ArcSetup setup{read.distance, read.sigmaHorizontal.radians() * perRoot,
                         read.sigmaVertical.radians() * perRoot, read.relation};
    m_fits.resize(draws.size());
    constexpr double farBelowScatter = 1e-6;  // of the draws
    const ArcSigma& sigma = m_task.fit.sigmas[arc];
    const double tolerance =
        farBelowScatter * std::min(sigma.x, sigma.y) / m_task.fit.arcs[arc].circle.radius;
    fitArcsFast(setup, m_a, m_e, m_fits, 1, std::max(usualTolerance, tolerance));
    const double elevation = read.arcs[arc].zeroElevation.radians(),
                 sigmaZeroE = read.sigmaOfZeroVertical(read.arcs[arc]).radians();
    for (std::size_t i = 0; i < draws.size(); ++i) {
      double* own = &centres[i * m_task.centres() + 2 * arc];
      const std::optional<FastArcFit>& fit = m_fits[i];
      const bool isFound = fit && isDetermined(*fit);
      // Angles determine only the shape; all lengths are proportional to L.
      const double longer = 1 + read.sigmaDistance / read.distance * draws[i].normals[DrawPlan::distance];
      own[0] = isFound ? fit->circle.x * longer : missingCentre;
      // A positive draw increases every e, which means a lower zero.
      const double zeroE = sigmaZeroE * draws[i].zeroScale * draws[i].normals[m_task.plan.zeros(arc) + 1];
      const double overZero = fit ? fit->circle.y - read.distance * std::tan(elevation - zeroE) : 0;
      own[1] = isFound ? overZero * longer : missingCentre;
    }
  }

  static bool isDetermined(const FastArcFit& fit) {
    ArcFit arc;
    arc.circle = fit.circle;
    arc.cofactor = fit.cofactor;
    return fit.circle.radius > 0 && !radiusUndetermined(arc);
  }

  RefitTask m_task;
  std::unique_ptr<Refit> m_general;
  std::vector<VisitColumns> m_arcs;
  std::vector<double> m_a, m_e;
  std::vector<std::optional<FastArcFit>> m_fits;
};

}  // namespace

std::unique_ptr<Refit> arcsRefit(const RefitTask& task) {
  if (!ArcsRefit::serves(task)) return nullptr;
  return std::make_unique<ArcsRefit>(task);
}

}  // namespace alidade
