#include "core/diagnosis/conclusion/location.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/observation/half_turn.h"

namespace alidade {

namespace {

using Eigen::Index;

/// A way to divide the readings.
enum class Division { Position, Circle, Face, Round, Sector, Time };

constexpr int sectorWidth = 30;  // degrees of slider coordinate

std::string nameOf(Division by) {
  switch (by) {
    case Division::Position:
      return "position";
    case Division::Circle:
      return "circle";
    case Division::Face:
      return "face";
    case Division::Round:
      return "round";
    case Division::Sector:
      return "sector";
    case Division::Time:
      return "time";
  }
  return "";
}

/// Factor of the axis in `positionNumber`, which sorts positions by axis, then by repeat.
constexpr int mostRepeats = 1000;
int positionNumber(const ArcMeasurement& arc) {
  return mostRepeats * arc.axisDeg + arc.repeat % mostRepeats;
}

/// `value` is a `positionNumber`, the first degree of a sector, a `ReadingKind`, or a number from 1.
std::string partName(Division by, int value) {
  if (by == Division::Circle) return std::string(nameOf(static_cast<ReadingKind>(value)));
  if (by == Division::Sector) return std::to_string(value) + "…" + std::to_string(value + sectorWidth) + "°";
  if (by == Division::Position) {
    const std::string name = std::to_string(value / mostRepeats);
    const int repeat = value % mostRepeats;
    return repeat > 1 ? name + ", time " + std::to_string(repeat) : name;
  }
  if (by == Division::Time) return "quarter " + std::to_string(value);
  return std::to_string(value);
}

int sectorOf(double s) {
  return static_cast<int>(std::floor(s * 180 / std::numbers::pi / sectorWidth)) * sectorWidth;
}

class Tally {
 public:
  void add(Division by, int value, double square, double expected) {
    Sum& sum = m_sums[by][value];
    sum.square += square;
    sum.expected += expected;
  }

  std::vector<GapShare> shares() const {
    std::vector<GapShare> shares;
    for (const auto& [by, parts] : m_sums) {
      double beyond = 0, all = 0;
      for (const auto& [value, sum] : parts) {
        beyond += std::max(0.0, sum.square - sum.expected);
        all += sum.square;
      }
      for (const auto& [value, sum] : parts) {
        const double part = beyond > 0 ? std::max(0.0, sum.square - sum.expected) / beyond
                            : all > 0  ? sum.square / all
                                       : 1.0 / static_cast<double>(parts.size());
        shares.push_back({nameOf(by), partName(by, value), part});
      }
    }
    return shares;
  }

 private:
  struct Sum {
    double square = 0, expected = 0;
  };
  std::map<Division, std::map<int, Sum>> m_sums;
};

}  // namespace

std::vector<GapShare> sharesOfReadings(const Leftover& leftover, const Measurement& measurement,
                                       const JointFit& fit) {
  Tally tally;
  const Index readings = leftover.readings();
  const auto isOfSameRow = [&](Index i, Index j) {
    return leftover.reading(i).arc == leftover.reading(j).arc &&
           leftover.reading(i).sighting == leftover.reading(j).sighting;
  };
  for (Index first = 0, next = 0; first < readings; first = next) {
    double squares = 0, expectations = 0;
    bool any = false;
    for (; next < readings && isOfSameRow(first, next); ++next) {
      if (!leftover.reading(next).takesPart || leftover.reading(next).isZero) continue;
      const double square = std::pow(leftover.residual()[next], 2), expected = leftover.redundancy(next);
      tally.add(Division::Circle, static_cast<int>(leftover.reading(next).kind), square, expected);
      squares += square;
      expectations += expected;
      any = true;
    }
    if (!any) continue;
    const LinearReading& reading = leftover.reading(first);
    const ArcMeasurement& arc = measurement.arcs[reading.arc];
    const Sighting& sighting = arc.sightings[reading.sighting];
    const auto quarter = 4 * sighting.sequence / std::max<std::size_t>(measurement.rows, 1);
    const double s = sliderCoordinateOf(fit.arcAngles[reading.arc][reading.sighting], arc.axisDeg);
    const auto add = [&](Division by, int value) { tally.add(by, value, squares, expectations); };
    add(Division::Position, positionNumber(arc));
    add(Division::Face, sighting.face);
    add(Division::Round, sighting.round);
    add(Division::Sector, sectorOf(s));
    add(Division::Time, static_cast<int>(quarter) + 1);
  }
  return tally.shares();
}

std::vector<GapShare> sharesOfClosures(const GapModel& own) {
  const auto upper = arcAt(*own.measurement, 0), lower = arcAt(*own.measurement, 180);
  if (!upper || !lower) return {};
  std::vector<GapShare> shares;
  const auto add = [&](std::string_view of, double square, double expected) {
    shares.push_back({"closure", std::string(of), std::max(0.0, square - expected)});
  };
  for (const auto& [of, quantity] : {std::pair(Closure::Of::Radius, Unknown::Kind::Radius),
                                     std::pair(Closure::Of::Centre, Unknown::Kind::CentreX)})
    if (const auto misclosure = misclosureOf(*own.fit, quantity, *upper, *lower, 1))
      add(nameOf(of), std::pow(misclosure->value / misclosure->sigma, 2), 1);
  // The common fit has the disagreement between repeats of an axis in its residuals.
  const std::optional<JointFit> apart = fitApart(*own.measurement, own.starts, own.options);
  if (apart)
    add(nameOf(Closure::Of::Repeat), own.fit->chiSquare - apart->chiSquare,
        own.fit->degreesOfFreedom - apart->degreesOfFreedom);
  double ofZeros = 0;
  const std::vector<Closure> zeros = zeroClosuresOf(*own.measurement, *own.fit, own.options);
  for (const Closure& closure : zeros) ofZeros += std::pow(closure.sigmas(), 2);
  if (!zeros.empty()) add(nameOf(Closure::Of::ZeroAzimuth), ofZeros, static_cast<double>(zeros.size()));
  if (shares.empty()) return shares;
  const JointFit& fit = apart ? *apart : *own.fit;
  add("readings", fit.chiSquare, fit.degreesOfFreedom);
  double sum = 0;
  for (const GapShare& share : shares) sum += share.share;
  for (GapShare& share : shares)
    share.share = sum > 0 ? share.share / sum : 1.0 / static_cast<double>(shares.size());
  return shares;
}

namespace {

/// Index of a reading in the leftover, which must contain the reading.
Index indexOf(const Leftover& leftover, const ReadingRef& reading) {
  Index index = 0;
  while (!(readingRef(leftover, index) == reading)) ++index;
  return index;
}

}  // namespace

std::vector<GapShare> sharesOfFrames(const Inquiry& inquiry) {
  constexpr double negligible = 1e-6;
  const Leftover& leftover = inquiry.leftover;
  std::map<ErrorSource, double> ofSource;
  double& readings = ofSource[ErrorSource::Reading];
  double noise = 0;
  // The redundancies are those of all readings, including excluded ones.
  const auto square = [&](Index reading, double sigmas) {
    return sigmas * sigmas * inquiry.ofAll().leftover.redundancy(reading);
  };
  for (const ExcludedReading& far : inquiry.excluded)
    readings += square(indexOf(inquiry.ofAll().leftover, far.reading), far.sigmas);
  for (const Explanation& explanation : inquiry.explanations) {
    const double chance = explanation.chance;
    if (chance < negligible) continue;
    for (const Part& part : explanation.parts)
      if (const auto reading = inquiry.of(part).grossErrorAt())
        readings += chance * square(*reading, part.weights[0]);
      else
        ofSource[inquiry.of(part).source()] += chance * inquiry.of(part).signatureSquare(part.weights);
    noise += chance * std::max(0.0, explanation.chiSquare - leftover.degreesOfFreedom());
  }
  const double guideway = ofSource[ErrorSource::Guideway], instrument = ofSource[ErrorSource::Instrument];
  std::vector<GapShare> shares;
  if (hasBothAxes(*inquiry.base.measurement)) {
    shares.push_back({"frame", "guideway", guideway});
    shares.push_back({"frame", "instrument", instrument});
  } else {
    shares.push_back({"frame", "guideway or instrument", guideway + instrument});
  }
  shares.push_back({"frame", "time", ofSource[ErrorSource::Time]});
  shares.push_back({"frame", "readings", readings});
  shares.push_back({"frame", "noise", noise});
  double sum = 0;
  for (const GapShare& share : shares) sum += share.share;
  for (GapShare& share : shares) share.share = sum > 0 ? share.share / sum : share.of == "noise" ? 1.0 : 0.0;
  return shares;
}

}  // namespace alidade
