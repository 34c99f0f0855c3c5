#include "ui/connection/reading_landing.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/angle_text.h"
#include "core/session/entry.h"
#include "core/session/face.h"
#include "core/session/sighting_order.h"
#include "ui/commands/change_field.h"
#include "ui/commands/replace_readings.h"
#include "ui/document/field.h"
#include "ui/document/session_document.h"
#include "ui/text/entry_text.h"
#include "ui/text/next_reading_text.h"
#include "ui/text/position_text.h"

namespace alidade::ui {

namespace {

struct ReadingLanding {
  Q_DECLARE_TR_FUNCTIONS(ReadingLanding)
};

/// Pointing zeros of one set-up look in one direction; no two targets of a bench are as near to each other.
constexpr Angle zeroTolerance = Angle::fromDegrees(1);

bool hasNoZero(const Position& position) {
  return position.zero.horizontal.empty() || position.zero.vertical.empty();
}

bool isOpenRow(const Reading& row) {
  return !row.excluded && (row.horizontal.empty() || row.vertical.empty());
}

/// Of a position that has its zero: the row to be read; a row more only where `mayAdd`.
std::optional<std::size_t> rowToRead(const Evaluation& evaluation, std::size_t position, bool mayAdd) {
  const std::vector<Reading>& rows = evaluation.session.positions[position].readings;
  const auto open = std::ranges::find_if(rows, isOpenRow);
  if (open != rows.end()) return static_cast<std::size_t>(open - rows.begin());
  const bool isKnown = evaluation.next.size() == evaluation.session.positions.size();
  return mayAdd && (!isKnown || evaluation.next[position]) ? std::optional(rows.size()) : std::nullopt;
}

int faceOf(const Reading& row) {
  const auto face = wholeEntry(faceRule, row.face);
  return face && *face ? **face : 1;
}

bool isFar(const FaceOneReading& read, const FaceOneReading& expected, Angle tolerance) {
  const auto off = [](Angle a, Angle b) { return std::abs(wrapped(a - b).radians()); };
  return off(read.horizontal, expected.horizontal) > tolerance.radians() ||
         off(read.vertical, expected.vertical) > tolerance.radians();
}

FaceOneReading inOne(const InstrumentReading& reading, VerticalCircle circle) {
  return inFaceOne(reading.horizontalAngle, reading.verticalAngle, reading.face, circle);
}

QString readAngles(const InstrumentReading& reading, CircleUnit unit) {
  return ReadingLanding::tr("%1 and %2")
      .arg(shownAngle(reading.horizontal, unit), shownAngle(reading.vertical, unit));
}

const char* zeroField(const InstrumentReading& reading, bool isVertical) {
  if (reading.face == 2)
    return isVertical ? "pointing_zero.face_2.vertical" : "pointing_zero.face_2.horizontal";
  return isVertical ? "pointing_zero.vertical" : "pointing_zero.horizontal";
}

QString zeroDoubt(const Evaluation& evaluation, const Landing& landing, const InstrumentReading& reading,
                  VerticalCircle circle, CircleUnit unit) {
  const auto& positions = evaluation.session.positions;
  for (const bool isVertical : {false, true}) {
    const std::string stands = fieldText(
        evaluation.session, {.position = landing.position, .field = zeroField(reading, isVertical)});
    if (!stands.empty())
      return ReadingLanding::tr("The pointing zero of %1 in face %2 stands already (%3), and %4 was read.")
          .arg(positionText(evaluation.session, landing.position))
          .arg(reading.face)
          .arg(shownAngle(stands, unit), readAngles(reading, unit));
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto horizontal = parseAngle(positions[i].zero.horizontal),
               vertical = parseAngle(positions[i].zero.vertical);
    if (i == landing.position || !horizontal || !vertical) continue;
    if (isFar(inOne(reading, circle), {*horizontal, *vertical}, zeroTolerance))
      return ReadingLanding::tr("Pointing zero of %1: %2 was read, and that of %3 is %4 and %5.")
          .arg(positionText(evaluation.session, landing.position), readAngles(reading, unit),
               positionText(evaluation.session, i), shownAngle(positions[i].zero.horizontal, unit),
               shownAngle(positions[i].zero.vertical, unit));
  }
  return {};
}

/// The row as it will stand: what is there, or the row to follow.
Reading landed(const Session& session, const Landing& landing, const InstrumentReading& reading) {
  const std::vector<Reading>& rows = session.positions[landing.position].readings;
  const bool isNew = *landing.row >= rows.size();
  Reading row = isNew ? followingReading(session, landing.position) : rows[*landing.row];
  row.horizontal = reading.horizontal;
  row.vertical = reading.vertical;
  row.tiltCrossArcsec = reading.tiltCrossArcsec;
  row.tiltLengthArcsec = reading.tiltLengthArcsec;
  row.corrections = reading.corrections;
  if (faceOf(row) != reading.face) row.face = std::to_string(reading.face);
  return row;
}

}  // namespace

Place Landing::place() const {
  if (row) return {.position = position, .reading = row, .field = "horizontal"};
  return {.position = position, .field = "pointing_zero.horizontal"};
}

std::optional<Landing> nextLanding(const Evaluation& evaluation, std::size_t position) {
  const auto& positions = evaluation.session.positions;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::size_t at = (position + i) % positions.size();
    if (hasNoZero(positions[at])) return Landing{at, {}};
    if (const auto row = rowToRead(evaluation, at, i == 0)) return Landing{at, row};
  }
  return {};
}

QString landingDoubt(const Evaluation& evaluation, const Landing& landing, const InstrumentReading& reading) {
  const Session& session = evaluation.session;
  const auto kind = verticalCircleEntry(session.geometry.verticalCircle);
  const VerticalCircle circle = kind ? *kind : VerticalCircle::Zenith;
  const CircleUnit unit = circleUnitOf(session);
  if (!landing.row) return zeroDoubt(evaluation, landing, reading, circle, unit);
  const std::vector<Reading>& rows = session.positions[landing.position].readings;
  const bool isThere = *landing.row < rows.size();
  const QString read = readAngles(reading, unit);
  if (isThere) {
    const Reading& row = rows[*landing.row];
    const std::string& stands = row.horizontal.empty() ? row.vertical : row.horizontal;
    if (!stands.empty())
      return ReadingLanding::tr("%1: %2 stands there already, and %3 was read.")
          .arg(sightingText(row), shownAngle(stands, unit), read);
    if (faceOf(row) != reading.face)
      return ReadingLanding::tr("%1: face %2 is asked for, and the circle reads face %3 (%4).")
          .arg(sightingText(row))
          .arg(faceOf(row))
          .arg(reading.face)
          .arg(read);
  }
  const bool isKnown = landing.position < evaluation.next.size() && evaluation.next[landing.position];
  if (!isKnown || evaluation.next[landing.position]->row != *landing.row) return {};
  const NextReading& next = *evaluation.next[landing.position];
  if (!next.expected) return {};
  const FaceOneReading expected =
      inFaceOne(next.expected->horizontal, next.expected->vertical, faceOf(next.sighting), circle);
  if (!isFar(inOne(reading, circle), expected, next.expected->tolerance)) return {};
  return ReadingLanding::tr("%1: %2 was read where about %3 and %4 was expected. Is it the right target?")
      .arg(sightingText(next.sighting), read, coarseAngleText(next.expected->horizontal, unit),
           coarseAngleText(next.expected->vertical, unit));
}

void land(SessionDocument& document, const Landing& landing, const InstrumentReading& reading) {
  const Session& session = document.session();
  if (landing.position >= session.positions.size()) return;
  if (!landing.row) {
    document.beginTogether(ReadingLanding::tr("Take pointing zero from the instrument"));
    changeField(document, {.position = landing.position, .field = zeroField(reading, false)},
                reading.horizontal);
    changeField(document, {.position = landing.position, .field = zeroField(reading, true)},
                reading.vertical);
    document.endTogether();
    return;
  }
  const std::vector<Reading>& rows = session.positions[landing.position].readings;
  const Reading row = landed(session, landing, reading);
  const QString text = ReadingLanding::tr("Take point %1 from the instrument").arg(qText(row.point));
  if (*landing.row >= rows.size())
    return replaceReadings(document, landing.position, rows.size(), 0, {row}, text,
                           journal_reasons::inserted);
  std::vector<NewText> texts;
  for (const ReadingColumnInfo& info : allReadingColumns())
    if (isEntered(info.column) &&
        enteredText(row, info.column) != enteredText(rows[*landing.row], info.column))
      texts.push_back({*landing.row, info.column, enteredText(row, info.column)});
  patchReadings(document, landing.position, ReadingsPatch(rows, texts), text, journal_reasons::retyped);
}

}  // namespace alidade::ui
