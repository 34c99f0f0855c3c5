#include "core/guidance/sightings_to_repeat.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <variant>

#include "core/adjustment/result/setup_findings.h"
#include "core/base/square.h"
#include "core/base/statistics.h"
#include "core/observation/guideway.h"
#include "core/observation/perfect_theodolite.h"
#include "core/observation/visits.h"
#include "core/observation/zero_line.h"

namespace alidade {

namespace {

constexpr double risk = 0.01;           // of naming anything in an error-free session, for each kind
constexpr double madOfNormal = 0.6745;  // the median of |x| of a standard normal variable

/// A difference that should agree with the others, with its σ.
struct Difference {
  std::vector<std::size_t> sightings;
  double value = 0;  ///< in units of `sigma`
  double sigma = 0;  ///< arcseconds
};

/// Finds the differences that deviate beyond the noise from their median, or from 0 unless `aboutMedian`. The
/// noise is the stated one, or the observed scatter if larger.
std::vector<SightingsToRepeat> farOnes(const std::vector<Difference>& differences,
                                       SightingsToRepeat::Reason reason, std::optional<ReadingKind> kind,
                                       bool aboutMedian) {
  if (differences.empty()) return {};
  std::vector<double> values;
  for (const Difference& difference : differences) values.push_back(difference.value);
  // With fewer than three differences it is unclear which one is wrong.
  if (aboutMedian && values.size() < 3) return {};
  const double middle = aboutMedian ? medianOf(values) : 0;
  for (double& value : values) value = std::abs(value - middle);
  const double scale = values.size() < 3 ? 1 : std::max(1.0, medianOf(values) / madOfNormal);
  const double limit =
      coverageFactor(1 - risk / static_cast<double>(values.size()), DegreesOfFreedom::infinite());
  std::vector<SightingsToRepeat> allToRepeat;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] > limit * scale)) continue;
    allToRepeat.push_back({.reason = reason,
                           .sightings = differences[i].sightings,
                           .kind = kind,
                           .size = (differences[i].value - middle) * differences[i].sigma,
                           .sigmas = values[i] / scale});
  }
  return allToRepeat;
}

class Comparison {
 public:
  Comparison(const FittedSession& fitted, const ProtocolProgress& progress)
      : m_fitted(fitted), m_progress(progress) {
    for (std::size_t i = 0; i < progress.sightings.size(); ++i) {
      const FollowedSighting& followed = progress.sightings[i];
      if (followed.position && followed.row && followed.state == SightingState::Taken)
        m_indices[{*followed.position, *followed.row}] = i;
    }
  }

  std::vector<SightingsToRepeat> allToRepeat() {
    misread();
    zeros();
    faces();
    ways();
    return std::move(m_allToRepeat);
  }

 private:
  /// Index of a row's sighting in the progress. Absent if the protocol lacks the row.
  std::optional<std::size_t> indexOf(std::size_t position, std::size_t row) const {
    const auto found = m_indices.find({position, row});
    return found == m_indices.end() ? std::nullopt : std::optional(found->second);
  }

  void misread() {
    for (const Suspect& suspect : m_fitted.suspects) {
      const auto index = indexOf(*suspect.where.position, *suspect.where.reading);
      if (!index || !m_named.insert(*index).second) continue;
      m_allToRepeat.push_back({.reason = SightingsToRepeat::Reason::Misread,
                               .sightings = {*index},
                               .kind = suspect.kind,
                               .size = suspect.size.arcseconds(),
                               .sigmas = std::abs(suspect.studentised)});
    }
  }

  void zeros() {
    for (const FitFinding& finding : setupFindings(m_fitted.measurement, m_fitted.fit)) {
      const auto* moved = std::get_if<setup_finding::ZeroMoved>(&finding.what);
      if (!moved) continue;
      const double across = moved->horizontal.radians() / moved->sigmaHorizontal.radians(),
                   up = moved->vertical.radians() / moved->sigmaVertical.radians();
      const bool isAcross = std::abs(across) >= std::abs(up);
      SightingsToRepeat toRepeat{.reason = SightingsToRepeat::Reason::ZeroMoved,
                                 .kind = isAcross ? ReadingKind::Horizontal : ReadingKind::Vertical,
                                 .size = (isAcross ? moved->horizontal : moved->vertical).arcseconds(),
                                 .sigmas = std::abs(isAcross ? across : up)};
      for (std::size_t i = 0; i < m_progress.sightings.size(); ++i) {
        const FollowedSighting& followed = m_progress.sightings[i];
        if (followed.planned.isZero && followed.planned.isAfter &&
            followed.position == finding.where.position && followed.state == SightingState::Taken)
          toRepeat.sightings.push_back(i);
      }
      if (!toRepeat.sightings.empty()) m_allToRepeat.push_back(std::move(toRepeat));
    }
  }

  void faces() {
    if (!m_fitted.twoFaces) return;
    std::vector<Difference> horizontal, vertical;
    // 2c(e) is the difference of two horizontal readings, the index half the sum of two vertical ones.
    const double sigmaOfTwo = std::numbers::sqrt2 * m_fitted.measurement.sigmaHorizontal.arcseconds(),
                 sigmaOfIndex = m_fitted.measurement.sigmaVertical.arcseconds() / std::numbers::sqrt2;
    for (const FaceDifference& visit : m_fitted.twoFaces->visits) {
      const ArcMeasurement& arc = m_fitted.measurement.arcs[visit.arc];
      std::vector<std::size_t> sightings;
      for (const std::size_t i : {visit.faceOne, visit.faceTwo})
        if (const auto index = indexOf(arc.position, arc.sightings[i].row)) sightings.push_back(*index);
      if (sightings.empty()) continue;
      horizontal.push_back({sightings, visit.fromCourse.arcseconds() / sigmaOfTwo, sigmaOfTwo});
      vertical.push_back({sightings, visit.index.arcseconds() / sigmaOfIndex, sigmaOfIndex});
    }
    addUnnamed(farOnes(horizontal, SightingsToRepeat::Reason::FacesDisagree, ReadingKind::Horizontal, true));
    addUnnamed(farOnes(vertical, SightingsToRepeat::Reason::FacesDisagree, ReadingKind::Vertical, true));
  }

  /// The deviation of a visit from the circle, arcseconds outward, with σ.
  struct Offset {
    std::vector<std::size_t> sightings;
    std::set<int> faces;
    double outward = 0, sigma = 0;
  };

  std::optional<Offset> offsetOf(const ArcMeasurement& arc, const Circle& circle, const Visit& visit) const {
    Offset offset;
    for (const std::size_t i : visit.sightings) {
      offset.faces.insert(arc.sightings[i].face);
      if (const auto index = indexOf(arc.position, arc.sightings[i].row)) offset.sightings.push_back(*index);
    }
    if (offset.sightings.empty()) return {};
    const Measurement& measurement = m_fitted.measurement;
    const PlanePoint<double> point = ZeroLine(measurement, arc).sightedPoint(visit.mean.direction);
    const double phi = nearestArcAngle(circle, point);
    const double millimetres = std::hypot(point.x - circle.x, point.y - circle.y) - circle.radius;
    offset.outward = Angle::fromRadians(millimetres / measurement.distance).arcseconds();
    const double across = std::cos(phi) * measurement.sigmaHorizontal.arcseconds(),
                 up = std::sin(phi) * measurement.sigmaVertical.arcseconds();
    offset.sigma = std::sqrt((square(across) + square(up)) / static_cast<double>(visit.sightings.size()));
    return offset;
  }

  /// Compares the deviations across the arc only, since the slider returns only approximately along it. The
  /// rounds must be in the same faces, so that instrument errors cancel.
  void ways() {
    std::vector<Difference> differences;
    for (const ArcMeasurement& arc : m_fitted.measurement.arcs) {
      const ArcFit* own = m_fitted.fit.arcOfPosition(arc.position);
      if (!own) continue;
      std::map<int, Offset> first;
      for (const Visit& visit : visitsOf(arc)) {
        const auto offset = offsetOf(arc, own->circle, visit);
        if (!offset) continue;
        const auto [before, isNew] = first.emplace(visit.point, *offset);
        if (isNew || before->second.faces != offset->faces) continue;
        Difference difference;
        difference.sigma = std::hypot(before->second.sigma, offset->sigma);
        difference.value = (offset->outward - before->second.outward) / difference.sigma;
        difference.sightings = before->second.sightings;
        difference.sightings.insert(difference.sightings.end(), offset->sightings.begin(),
                                    offset->sightings.end());
        differences.push_back(std::move(difference));
      }
    }
    addUnnamed(farOnes(differences, SightingsToRepeat::Reason::WaysDisagree, {}, false));
  }

  /// Adds the repeats without a sighting that is already named, the largest deviation in σ first.
  void addUnnamed(std::vector<SightingsToRepeat> allToRepeat) {
    std::ranges::sort(allToRepeat, std::greater{}, &SightingsToRepeat::sigmas);
    for (SightingsToRepeat& toRepeat : allToRepeat) {
      const auto isNamed = [&](std::size_t index) { return m_named.contains(index); };
      if (std::ranges::any_of(toRepeat.sightings, isNamed)) continue;
      m_named.insert(toRepeat.sightings.begin(), toRepeat.sightings.end());
      m_allToRepeat.push_back(std::move(toRepeat));
    }
  }

  const FittedSession& m_fitted;
  const ProtocolProgress& m_progress;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_indices;  ///< by position and row
  std::set<std::size_t> m_named;
  std::vector<SightingsToRepeat> m_allToRepeat;
};

}  // namespace

std::vector<SightingsToRepeat> sightingsToRepeat(const FittedSession& fitted,
                                                 const ProtocolProgress& progress) {
  return Comparison(fitted, progress).allToRepeat();
}

}  // namespace alidade
