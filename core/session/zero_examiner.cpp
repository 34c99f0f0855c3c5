#include "core/session/zero_examiner.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/square.h"
#include "core/base/visible_text.h"
#include "core/session/entry.h"
#include "core/session/face.h"
#include "core/session/problem_reporter.h"
#include "core/session/protocol_progress.h"
#include "core/session/row_fields.h"
#include "core/session/time_text.h"

namespace alidade {

namespace {

/// One sighting converted to face 1, relative to the first.
struct FromFirst {
  int face = 1;
  bool isAfter = false;
  Angle horizontal, vertical;
  std::optional<double> minutes = {};

  bool operator==(const FromFirst&) const = default;
};

struct PositionZero {
  std::optional<FaceOneReading> first;
  std::vector<FromFirst> sightings;  ///< all sightings, the first included
};

class ZeroExaminer : private ProblemReporter {
 public:
  ZeroExaminer(const PointingZero& zero, std::size_t position, const std::optional<VerticalCircle>& circle)
      : m_zero(zero), m_position(position), m_circle(circle) {}

  std::pair<PositionZero, std::vector<Problem>> examine() {
    PositionZero read;
    read.first = sighting(m_zero.horizontal, m_zero.vertical, "pointing_zero", 1);
    if (read.first) read.sightings.push_back({1, false, {}, {}, minutesOf(m_zero.takenAt)});
    for (const ZeroSlot& slot : furtherZeros) {
      const ZeroSighting& texts = m_zero.*slot.sighting;
      if (texts.horizontal.empty() && texts.vertical.empty()) continue;
      const std::string field = zeroField(slot);
      const auto circles = sighting(texts.horizontal, texts.vertical, field, slot.face);
      if (!circles || !read.first) continue;
      const FromFirst from{slot.face, slot.isAfter, wrapped(circles->horizontal - read.first->horizontal),
                           wrapped(circles->vertical - read.first->vertical), minutesOf(texts.takenAt)};
      const bool isNear = checkDistance(from.horizontal, texts.horizontal, field + ".horizontal") &&
                          checkDistance(from.vertical, texts.vertical, field + ".vertical");
      if (isNear) read.sightings.push_back(from);
    }
    return {std::move(read), std::move(m_problems)};
  }

 private:
  std::optional<FaceOneReading> sighting(const std::string& horizontal, const std::string& vertical,
                                         const std::string& field, int face) {
    const auto a = angle(horizontalRule, horizontal, field + ".horizontal");
    const auto b = angle(verticalRule, vertical, field + ".vertical");
    if (!a || !b || !m_circle) return std::nullopt;
    return inFaceOne(*a, *b, face, *m_circle);
  }

  std::optional<Angle> angle(const AngleRule& rule, const std::string& text, const std::string& field) {
    // If the kind of circle is unknown, the wider range of the elevation circle applies.
    return take(angleEntry(rule, text, m_circle.value_or(VerticalCircle::Elevation)),
                {.position = m_position, .field = field})
        .value_or(std::nullopt);
  }

  bool checkDistance(Angle from, const std::string& text, const std::string& field) {
    const double degrees = std::abs(from.degrees());
    if (degrees <= farthestZeroSighting) return true;
    report(zeroApartProblem(text, degrees), {.position = m_position, .field = field});
    return false;
  }

  const PointingZero& m_zero;
  const std::size_t m_position;
  const std::optional<VerticalCircle> m_circle;
};

/// Means of the sightings in one face.
struct FaceMean {
  int count = 0;
  Angle horizontal, vertical;
};

template <typename Takes>
FaceMean meanOf(const std::vector<FromFirst>& sightings, const Takes& takes) {
  FaceMean mean;
  for (const FromFirst& one : sightings) {
    if (!takes(one)) continue;
    ++mean.count;
    mean.horizontal = mean.horizontal + one.horizontal;
    mean.vertical = mean.vertical + one.vertical;
  }
  if (mean.count == 0) return mean;
  return {mean.count, mean.horizontal * (1.0 / mean.count), mean.vertical * (1.0 / mean.count)};
}

FaceMean meanOfFace(const std::vector<FromFirst>& sightings, int face) {
  return meanOf(sightings, [face](const FromFirst& one) { return one.face == face; });
}

/// The mean change of the zero in the faces sighted both before and after the readings; absent if none was.
std::optional<ZeroSightings::Move> moveOf(const std::vector<FromFirst>& sightings) {
  ZeroSightings::Move move{.horizontal = {}, .vertical = {}, .factor = 0};
  int faces = 0;
  for (const int face : {1, 2}) {
    const auto at = [&](bool isAfter) {
      return meanOf(sightings,
                    [&](const FromFirst& one) { return one.face == face && one.isAfter == isAfter; });
    };
    const FaceMean before = at(false), after = at(true);
    if (before.count == 0 || after.count == 0) continue;
    ++faces;
    move.horizontal = move.horizontal + (after.horizontal - before.horizontal);
    move.vertical = move.vertical + (after.vertical - before.vertical);
    move.factor += 1.0 / before.count + 1.0 / after.count;
  }
  if (faces == 0) return std::nullopt;
  return ZeroSightings::Move{move.horizontal * (1.0 / faces), move.vertical * (1.0 / faces),
                             std::sqrt(move.factor) / faces};
}

/// The sightings relative to their mean. `horizontal`, `vertical`: the mean minus the first sighting.
std::vector<SightedZero> apartFrom(const std::vector<FromFirst>& sightings, Angle horizontal, Angle vertical,
                                   double up) {
  std::vector<SightedZero> apart;
  for (const FromFirst& one : sightings)
    apart.push_back({.face = one.face,
                     .isAfter = one.isAfter,
                     .a = one.horizontal - horizontal,
                     .e = (one.vertical - vertical) * up,
                     .minutes = one.minutes});
  return apart;
}

/// Returns the zero: the mean over the faces that count, each with the mean of its sightings. `up`: 1 if the
/// vertical circle increases upwards, otherwise −1.
ZeroDirection directionOf(const PositionZero& zero, bool withFaceTwo, double up) {
  std::vector<FromFirst> counting = zero.sightings;
  std::erase_if(counting, [&](const FromFirst& one) { return one.face == 2 && !withFaceTwo; });
  ZeroSightings how{.count = static_cast<int>(counting.size()),
                    .isInBothFaces = withFaceTwo,
                    .factor = 0,
                    .hasLeftOutFace = counting.size() < zero.sightings.size(),
                    .moved = moveOf(counting)};
  const int faces = withFaceTwo ? 2 : 1;
  Angle horizontal, vertical;
  for (int face = 1; face <= faces; ++face) {
    const FaceMean mean = meanOfFace(counting, face);
    horizontal = horizontal + mean.horizontal * (1.0 / faces);
    vertical = vertical + mean.vertical * (1.0 / faces);
    how.factor += 1.0 / mean.count;
  }
  how.factor = std::sqrt(how.factor) / faces;
  return {zero.first->horizontal + horizontal, zero.first->vertical + vertical, how,
          apartFrom(counting, horizontal, vertical, up)};
}

/// χ² of the sightings about the means of their faces, with its degrees of freedom.
struct Scatter {
  double chiSquare = 0;
  int degreesOfFreedom = 0;
};

void addScatter(Scatter& scatter, const std::vector<FromFirst>& sightings, Angle sigmaHorizontal,
                Angle sigmaVertical) {
  for (const int face : {1, 2}) {
    const FaceMean mean = meanOfFace(sightings, face);
    if (mean.count < 2) continue;
    for (const FromFirst& one : sightings) {
      if (one.face != face) continue;
      if (sigmaHorizontal > Angle())
        scatter.chiSquare += square((one.horizontal - mean.horizontal).radians() / sigmaHorizontal.radians());
      if (sigmaVertical > Angle())
        scatter.chiSquare += square((one.vertical - mean.vertical).radians() / sigmaVertical.radians());
    }
    scatter.degreesOfFreedom +=
        (mean.count - 1) * ((sigmaHorizontal > Angle() ? 1 : 0) + (sigmaVertical > Angle() ? 1 : 0));
  }
}

/// Gives each position the sightings of all positions; false if two sightings contradict each other.
bool poolSightings(std::vector<PositionZero>& zeros) {
  std::map<std::pair<int, bool>, FromFirst> pooled;
  const FaceOneReading* first = nullptr;
  for (const PositionZero& zero : zeros) {
    if (!zero.first) continue;
    if (!first) first = &*zero.first;
    if (!areEqualAsTyped(first->horizontal, zero.first->horizontal) ||
        !areEqualAsTyped(first->vertical, zero.first->vertical))
      return false;
    for (const FromFirst& one : zero.sightings) {
      const auto [found, isNew] = pooled.emplace(std::pair(one.face, one.isAfter), one);
      if (!areEqualAsTyped(found->second.horizontal, one.horizontal) ||
          !areEqualAsTyped(found->second.vertical, one.vertical))
        return false;
    }
  }
  std::vector<FromFirst> sightings;
  for (const auto& [slot, one] : pooled) sightings.push_back(one);
  for (PositionZero& zero : zeros)
    if (zero.first) zero.sightings = sightings;
  return true;
}

bool isInFaceTwo(const PositionZero& zero) {
  return std::ranges::find(zero.sightings, 2, &FromFirst::face) != zero.sightings.end();
}

}  // namespace

Problem zeroApartProblem(const std::string& text, double degrees) {
  return {Phrase::of("%1 is %2° from the first sighting of the pointing zero: check the degrees and the face",
                     quotation(text), fixedText(degrees, 1))};
}

ExaminedZeros examineZeros(const Session& session, const std::optional<VerticalCircle>& circle,
                           PointingZeros kind, Angle sigmaHorizontal, Angle sigmaVertical) {
  ExaminedZeros examined;
  std::vector<PositionZero> zeros;
  for (std::size_t i = 0; i < session.positions.size(); ++i) {
    auto [zero, problems] = ZeroExaminer(session.positions[i].zero, i, circle).examine();
    zeros.push_back(std::move(zero));
    examined.ofPositions.push_back({{}, std::move(problems)});
  }
  examined.isOneOfSeveral = kind == PointingZeros::One && !poolSightings(zeros);
  const bool isOne = kind == PointingZeros::One && !examined.isOneOfSeveral;
  const bool withFaceTwo =
      std::ranges::all_of(zeros, [](const PositionZero& zero) { return !zero.first || isInFaceTwo(zero); });
  Scatter scatter;
  bool isCounted = false;
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    if (!zeros[i].first) continue;
    const double up = circle.value_or(VerticalCircle::Zenith) == VerticalCircle::Zenith ? -1 : 1;
    examined.ofPositions[i].direction = directionOf(zeros[i], withFaceTwo, up);
    if (!isOne || !isCounted) addScatter(scatter, zeros[i].sightings, sigmaHorizontal, sigmaVertical);
    isCounted = true;
  }
  if (scatter.degreesOfFreedom > 0)
    examined.scatter = std::max(1.0, std::sqrt(scatter.chiSquare / scatter.degreesOfFreedom));
  return examined;
}

std::optional<Angle> zeroElevation(Angle vertical, VerticalCircle circle) {
  const Angle elevation =
      wrapped(circle == VerticalCircle::Zenith ? Angle::fromDegrees(90) - vertical : vertical);
  return std::abs(elevation.degrees()) <= steepestZero ? std::optional(elevation) : std::nullopt;
}

}  // namespace alidade
