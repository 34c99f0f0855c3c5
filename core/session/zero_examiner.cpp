#include "core/session/zero_examiner.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/session/entry.h"
#include "core/session/face.h"
#include "core/session/problem_reporter.h"
#include "core/session/protocol_progress.h"
#include "core/session/row_fields.h"
#include "core/session/time_text.h"
#include "core/session/zero_mean.h"

namespace alidade {

namespace {

struct PositionZero {
  std::optional<FaceOneReading> first;
  /// All sightings, converted to face 1, minus the first, which is included. `e` is that of the vertical
  /// circle, which need not increase upwards.
  std::vector<SightedZero> sightings;
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
      const SightedZero from{slot.face, slot.isAfter, wrapped(circles->horizontal - read.first->horizontal),
                             wrapped(circles->vertical - read.first->vertical), minutesOf(texts.takenAt)};
      const bool isNear = checkDistance(from.a, texts.horizontal, field + ".horizontal") &&
                          checkDistance(from.e, texts.vertical, field + ".vertical");
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

/// Returns the zero of a position. `up`: 1 if the vertical circle increases upwards, otherwise −1.
ZeroDirection directionOf(const PositionZero& zero, bool withFaceTwo, double up) {
  const ZeroMean mean = zeroMeanOf(zero.sightings, withFaceTwo);
  ZeroDirection direction{zero.first->horizontal + mean.a, zero.first->vertical + mean.e, mean.sightings, {}};
  for (SightedZero one : zero.sightings) {
    if (one.face == 2 && !withFaceTwo) continue;
    one.a = one.a - mean.a;
    one.e = (one.e - mean.e) * up;
    direction.each.push_back(one);
  }
  return direction;
}

/// Gives each position the sightings of all positions; false if two sightings contradict each other.
bool poolSightings(std::vector<PositionZero>& zeros) {
  std::map<std::pair<int, bool>, SightedZero> pooled;
  const FaceOneReading* first = nullptr;
  for (const PositionZero& zero : zeros) {
    if (!zero.first) continue;
    if (!first) first = &*zero.first;
    if (!areEqualAsTyped(first->horizontal, zero.first->horizontal) ||
        !areEqualAsTyped(first->vertical, zero.first->vertical))
      return false;
    for (const SightedZero& one : zero.sightings) {
      const auto [found, isNew] = pooled.emplace(std::pair(one.face, one.isAfter), one);
      if (!areEqualAsTyped(found->second.a, one.a) || !areEqualAsTyped(found->second.e, one.e)) return false;
    }
  }
  std::vector<SightedZero> sightings;
  for (const auto& [slot, one] : pooled) sightings.push_back(one);
  for (PositionZero& zero : zeros)
    if (zero.first) zero.sightings = sightings;
  return true;
}

bool isInFaceTwo(const PositionZero& zero) {
  return std::ranges::find(zero.sightings, 2, &SightedZero::face) != zero.sightings.end();
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
  ZeroScatter scatter(sigmaHorizontal, sigmaVertical);
  bool isCounted = false;
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    if (!zeros[i].first) continue;
    const double up = circle.value_or(VerticalCircle::Zenith) == VerticalCircle::Zenith ? -1 : 1;
    examined.ofPositions[i].direction = directionOf(zeros[i], withFaceTwo, up);
    if (!isOne || !isCounted) scatter.add(zeros[i].sightings);
    isCounted = true;
  }
  examined.scatter = scatter.factor();
  return examined;
}

std::optional<Angle> zeroElevation(Angle vertical, VerticalCircle circle) {
  const Angle elevation =
      wrapped(circle == VerticalCircle::Zenith ? Angle::fromDegrees(90) - vertical : vertical);
  return std::abs(elevation.degrees()) <= steepestZero ? std::optional(elevation) : std::nullopt;
}

}  // namespace alidade
