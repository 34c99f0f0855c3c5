#include "ui/connection/reading_landing.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/angle_text.h"
#include "core/session/entry.h"
#include "core/session/row_fields.h"
#include "core/session/sighting_order.h"
#include "ui/commands/change_session.h"
#include "ui/commands/replace_readings.h"
#include "ui/document/field.h"
#include "ui/document/session_document.h"
#include "ui/text/entry_text.h"
#include "ui/text/next_reading_text.h"

namespace alidade::ui {

namespace {

struct ReadingLanding {
  Q_DECLARE_TR_FUNCTIONS(ReadingLanding)
};

/// Sightings of one pointing zero differ by less than this angle, whatever the errors of the instrument.
constexpr Angle zeroWithin = Angle::fromDegrees(0.5);

int faceOf(const Reading& row) {
  const auto face = wholeEntry(faceRule, row.face);
  return face && *face ? **face : 1;
}

bool isOpenRow(const Reading& row) {
  return !row.excluded && row.horizontal.empty() && row.vertical.empty();
}

/// True if a valid protocol determines the next sighting.
bool isLed(const Evaluation& evaluation) {
  return evaluation.guide && evaluation.guide->problem.empty();
}

/// True if the session lacks the position of the protocol's next sighting.
bool isBeyondSession(const Evaluation& evaluation) {
  if (!isLed(evaluation)) return false;
  const ProtocolProgress& progress = evaluation.guide->progress;
  return progress.next && !progress.sightings[*progress.next].position;
}

std::string zeroOf(int face, bool isAfter) {
  PlannedSighting planned;
  planned.face = face;
  planned.isAfter = isAfter;
  return zeroField(planned);
}

bool isEmptyZero(const ZeroSighting& zero) {
  return zero.horizontal.empty() && zero.vertical.empty();
}

/// The open row that has the expected point and round, and the face of the reading; if there is none, the
/// expected row.
std::size_t rowInItsFace(const Session& session, const EntryToCome& entry, int face) {
  const std::vector<Reading>& rows = session.positions[entry.position].readings;
  const Reading& wanted = entry.sighting;
  const auto isIt = [&](const Reading& row) {
    return isOpenRow(row) && row.point == wanted.point && row.round == wanted.round && faceOf(row) == face;
  };
  if (faceOf(wanted) == face) return entry.row;
  const auto found = std::ranges::find_if(rows, isIt);
  return found == rows.end() ? entry.row : static_cast<std::size_t>(found - rows.begin());
}

Landing landingOf(const Session& session, const EntryToCome& entry, int face) {
  if (!entry.zero.empty()) return {.entry = entry, .zero = zeroOf(face, entry.isAfter)};
  return {.entry = entry, .row = rowInItsFace(session, entry, face)};
}

/// A further sighting of the pointing zero; absent if the reading points elsewhere or the sighting exists.
std::optional<Landing> furtherZero(const Session& session, std::size_t position,
                                   const InstrumentReading& reading) {
  if (!looksAt(reading, session, position, zeroWithin)) return std::nullopt;
  const std::vector<Reading>& rows = session.positions[position].readings;
  const bool isAfter = std::ranges::any_of(rows, [](const Reading& row) { return !row.horizontal.empty(); });
  Landing landing{.zero = zeroOf(reading.face, isAfter), .isProposed = true};
  landing.entry = {.position = position, .zero = landing.zero, .zeroFace = reading.face, .isAfter = isAfter};
  if (!isEmptyZero(zeroAt(session, position, landing.zero))) return std::nullopt;
  return landing;
}

/// The row of the landing, or a new row after the last one, with the reading entered into it.
Reading landedRow(const SessionDocument& document, const Landing& landing, const InstrumentReading& reading) {
  const std::vector<Reading>& rows = document.session().positions[landing.position()].readings;
  Reading row = *landing.row < rows.size()
                    ? rows[*landing.row]
                    : followingReading(document.session(), landing.position(), document.chosenSighting());
  row.horizontal = reading.horizontal;
  row.vertical = reading.vertical;
  row.tiltCrossArcsec = reading.tiltCrossArcsec;
  row.tiltLengthArcsec = reading.tiltLengthArcsec;
  row.corrections = reading.corrections;
  row.takenAt = reading.takenAt;
  row.returnCode = reading.returnCode;
  row.instrumentSerial = reading.serial;
  if (faceOf(row) != reading.face) row.face = std::to_string(reading.face);
  return row;
}

void landInZero(SessionDocument& document, const Landing& landing, const InstrumentReading& reading) {
  const std::pair<const char*, const std::string&> texts[] = {{".horizontal", reading.horizontal},
                                                              {".vertical", reading.vertical},
                                                              {".taken_at", reading.takenAt},
                                                              {".return_code", reading.returnCode},
                                                              {".instrument_serial", reading.serial}};
  document.beginTogether(ReadingLanding::tr("Take pointing zero from the instrument"));
  for (const auto& [key, text] : texts)
    changeField(document, {.position = landing.position(), .field = landing.zero + key}, text);
  document.endTogether();
}

}  // namespace

Place Landing::place() const {
  if (row) return {.position = position(), .reading = row, .field = "horizontal"};
  return {.position = position(), .field = zero + ".horizontal"};
}

std::optional<Landing> nextLanding(const Evaluation& evaluation, std::size_t here,
                                   const InstrumentReading& reading) {
  const Session& session = evaluation.session;
  if (here >= session.positions.size() || isBeyondSession(evaluation)) return std::nullopt;
  const bool isTyped = !evaluation.next.empty();  // false: more than 10 000 rows (`nextReadings`)
  const auto entry = isTyped ? entryToCome(evaluation, here) : entryToComeOf(session, here);
  const bool isRow = !entry || entry->zero.empty();
  if (isRow && !isLed(evaluation))
    if (auto zero = furtherZero(session, entry ? entry->position : here, reading)) {
      if (entry) zero->entry = *entry;
      return zero;
    }
  return entry ? std::optional(landingOf(session, *entry, reading.face)) : std::nullopt;
}

Landing landingInRow(const Session& session, std::size_t position, std::size_t row) {
  const std::vector<Reading>& rows = session.positions.at(position).readings;
  Landing landing;
  landing.entry.position = position;
  landing.entry.row = row;
  landing.entry.sighting = row < rows.size() ? rows[row] : followingReading(session, position);
  landing.row = row;
  landing.isChosen = true;
  return landing;
}

void land(SessionDocument& document, const Landing& landing, const InstrumentReading& reading) {
  const Session& session = document.session();
  if (landing.position() >= session.positions.size()) return;
  if (!landing.row) return landInZero(document, landing, reading);
  const std::vector<Reading>& rows = session.positions[landing.position()].readings;
  const Reading row = landedRow(document, landing, reading);
  const QString text = ReadingLanding::tr("Take point %1 from the instrument").arg(qText(row.point));
  if (*landing.row >= rows.size())
    return replaceReadings(document, landing.position(), rows.size(), 0, {row}, text,
                           journal_reasons::inserted);
  std::vector<NewText> texts;
  for (const ReadingColumnInfo& info : allReadingColumns())
    if (isEntered(info.column) &&
        enteredText(row, info.column) != enteredText(rows[*landing.row], info.column))
      texts.push_back({*landing.row, info.column, enteredText(row, info.column)});
  patchReadings(document, landing.position(), ReadingsPatch(rows, texts), text, journal_reasons::retyped);
}

ZeroSighting zeroAt(const Session& session, std::size_t position, const std::string& zero) {
  const PointingZero& all = session.positions.at(position).zero;
  for (const ZeroSlot& slot : furtherZeros)
    if (zero == zeroField(slot)) return all.*slot.sighting;
  return firstSighting(all);
}

FaceOneReading inFaceOne(const InstrumentReading& reading, const Session& session) {
  const auto kind = verticalCircleEntry(session.geometry.verticalCircle);
  return inFaceOne(reading.horizontalAngle, reading.verticalAngle, reading.face,
                   kind ? *kind : VerticalCircle::Zenith);
}

bool isFar(const FaceOneReading& read, const FaceOneReading& expected, Angle tolerance) {
  const auto off = [](Angle a, Angle b) { return std::abs(wrapped(a - b).radians()); };
  return off(read.horizontal, expected.horizontal) > tolerance.radians() ||
         off(read.vertical, expected.vertical) > tolerance.radians();
}

bool looksAt(const InstrumentReading& reading, const Session& session, std::size_t position,
             Angle tolerance) {
  const PointingZero& zero = session.positions.at(position).zero;
  const auto horizontal = parseAngle(zero.horizontal), vertical = parseAngle(zero.vertical);
  if (!horizontal || !vertical) return false;
  return !isFar(inFaceOne(reading, session), {*horizontal, *vertical}, tolerance);
}

}  // namespace alidade::ui
