#include "core/session/position_examiner.h"

#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/session/entry.h"
#include "core/session/face.h"
#include "core/session/problem_reporter.h"
#include "core/session/row_fields.h"
#include "core/session/time_text.h"

namespace alidade {

namespace {

/// Sightings on the arc are within this angle of the pointing zero. Beyond it, the tangents are excessive.
constexpr double widestDegrees = 80;

/// The round, point and face of a row, unique within a position.
using VisitFace = std::tuple<int, int, int>;

class PositionExaminer : private ProblemReporter {
 public:
  PositionExaminer(const Position& position, std::size_t index, std::size_t firstSequence,
                   const ExaminedZero& zero, const std::optional<VerticalCircle>& circle)
      : m_position(position),
        m_index(index),
        m_firstSequence(firstSequence),
        m_zero(zero.direction),
        m_circle(circle) {
    m_rowOfVisitFace.reserve(position.readings.size());
    m_problems = zero.problems;
  }

  ExaminedPosition examine() {
    const std::vector<Reading>& rows = m_position.readings;
    m_examined.sightings.reserve(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].excluded) continue;
      if (const auto sighting = examineRow(rows[i], {.position = m_index, .reading = i}))
        m_examined.sightings.push_back(*sighting);
    }
    m_examined.problems = std::move(m_problems);
    return std::move(m_examined);
  }

 private:
  /// If the kind of circle is unknown, the wider range of the elevation circle applies.
  VerticalCircle circleForRanges() const { return m_circle.value_or(VerticalCircle::Elevation); }

  static Place at(Place place, const char* field) {
    place.field = field;
    return place;
  }

  /// The value of an entry; empty, with a problem reported, if it cannot be used. The place is built only for
  /// a problem.
  template <typename Value>
  std::optional<Value> valueOf(const Result<Value>& entry, const Place& place, const char* field) {
    if (entry) return *entry;
    report(entry.problem(), at(place, field));
    return std::nullopt;
  }

  std::optional<Angle> angle(const AngleRule& rule, const std::string& text, const Place& place,
                             const char* field) {
    return valueOf(angleEntry(rule, text, circleForRanges()), place, field).value_or(std::nullopt);
  }

  std::optional<Angle> tilt(const std::string& text, const Place& place, const char* field) {
    if (text.empty()) return std::nullopt;
    return valueOf(tiltEntry(text), place, field).value_or(std::nullopt);
  }

  /// Returns the row relative to the zero; absent if the row or the zero cannot be used.
  std::optional<Sighting> examineRow(const Reading& row, const Place& place) {
    if (isBlank(row)) {
      report({Phrase::of("is empty, as is the whole row: type its readings or delete the row")},
             at(place, "horizontal"));
      return std::nullopt;
    }
    const std::size_t before = m_problems.size();
    Sighting sighting;
    sighting.row = *place.reading;
    sighting.sequence = m_firstSequence + sighting.row;
    sighting.minutes = minutesOf(row.takenAt);
    examineVisit(row, place, sighting);
    const auto horizontal = angle(horizontalRule, row.horizontal, place, "horizontal");
    const auto vertical = angle(verticalRule, row.vertical, place, "vertical");
    const std::size_t beforeReduction = m_problems.size();
    if (horizontal && vertical && m_zero && m_circle && beforeReduction == before) {
      reduce(inFaceOne(*horizontal, *vertical, sighting.face, *m_circle), *m_zero, sighting);
      checkWidth(sighting.a, row.horizontal, place, "horizontal");
      checkWidth(sighting.e, row.vertical, place, "vertical");
      checkSteepness(*m_zero, sighting.e, row.vertical, place);
    }
    sighting.slider = angle(sliderRule, row.slider, place, "slider");
    sighting.tiltCross = tilt(row.tiltCrossArcsec, place, "tilt_cross_arcsec");
    sighting.tiltLength = tilt(row.tiltLengthArcsec, place, "tilt_length_arcsec");
    if (!row.corrections.empty())
      sighting.corrections =
          valueOf(correctionsEntry(row.corrections), place, "corrections").value_or(std::nullopt);
    if (m_problems.size() > before || !m_zero) return std::nullopt;
    return sighting;
  }

  /// Examines point, round and face; a repetition of all three within a position is an error.
  void examineVisit(const Reading& row, const Place& place, Sighting& sighting) {
    const auto point = valueOf(wholeEntry(pointRule, row.point), place, "point");
    const auto round = valueOf(wholeEntry(roundRule, row.round), place, "round");
    const auto face = valueOf(wholeEntry(faceRule, row.face), place, "face");
    if (!point || !round || !face) return;
    sighting.point = point->value_or(static_cast<int>(*place.reading) + 1);
    sighting.round = **round;
    sighting.face = **face;
    const std::size_t first =
        m_rowOfVisitFace.try_emplace({sighting.round, sighting.point, sighting.face}, *place.reading)
            .first->second;
    if (first == *place.reading) return;
    report({Phrase::of("point %1, round %2, %3 is already in row %4: give it another point or round, or "
                       "exclude one",
                       sighting.point, sighting.round, faceName(sighting.face), first + 1)},
           at(place, "point"));
  }

  void reduce(const FaceOneReading& circles, const ZeroDirection& zero, Sighting& sighting) const {
    sighting.a = wrapped(circles.horizontal - zero.horizontal);
    const bool zenith = *m_circle == VerticalCircle::Zenith;
    sighting.e = wrapped(zenith ? zero.vertical - circles.vertical : circles.vertical - zero.vertical);
  }

  void checkWidth(Angle reduced, const std::string& text, const Place& place, const char* field) {
    const double degrees = std::abs(reduced.degrees());
    if (degrees < widestDegrees) return;
    report({Phrase::of("%1 lies %2° from the pointing zero, farther than the arc can be sighted: check the "
                       "degrees and the face",
                       quotation(text), fixedText(degrees, 0))},
           at(place, field));
  }

  /// Checks the elevation from the horizon, which differs from e if the zero is inclined.
  void checkSteepness(const ZeroDirection& zero, Angle e, const std::string& text, const Place& place) {
    const auto zeroUp = zeroElevation(zero.vertical, *m_circle);
    if (!zeroUp || std::abs(e.degrees()) >= widestDegrees) return;
    const double degrees = std::abs((*zeroUp + e).degrees());
    if (degrees < widestDegrees) return;
    report({Phrase::of("%1 is %2° away from the horizon, too steep for a sighting of the arc: check the "
                       "degrees and the face",
                       quotation(text), fixedText(degrees, 0))},
           at(place, "vertical"));
  }

  const Position& m_position;
  const std::size_t m_index, m_firstSequence;
  const std::optional<ZeroDirection> m_zero;
  const std::optional<VerticalCircle> m_circle;
  ExaminedPosition m_examined;
  std::unordered_map<VisitFace, std::size_t, boost::hash<VisitFace>> m_rowOfVisitFace;  ///< first row
};

}  // namespace

ExaminedPosition examinePosition(const Position& position, std::size_t index, std::size_t firstSequence,
                                 const ExaminedZero& zero, const std::optional<VerticalCircle>& circle) {
  return PositionExaminer(position, index, firstSequence, zero, circle).examine();
}

}  // namespace alidade
