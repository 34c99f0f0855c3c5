#include "ui/connection/reading_doubts.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/angle_text.h"
#include "core/session/entry.h"
#include "core/session/face.h"
#include "core/session/row_fields.h"
#include "core/wording/guidance.h"
#include "ui/text/entry_text.h"
#include "ui/text/next_reading_text.h"
#include "ui/text/position_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

struct ReadingDoubts {
  Q_DECLARE_TR_FUNCTIONS(ReadingDoubts)
};

/// Two sightings of the pointing zero from one set-up differ by less than this angle, two targets by more.
constexpr Angle zeroTolerance = Angle::fromDegrees(1);
/// Two angles count as equal if they differ by less than this, since no circle has a finer resolution.
constexpr double sameWithin = 1e-4;  // arcsec
/// In a position with more rows than this, only the typed texts are compared.
constexpr std::size_t mostCompared = 10'000;
constexpr int longestSerial = 40;

int expectedFace(const EntryToCome& entry) {
  if (!entry.zero.empty()) return entry.zeroFace;
  const auto face = wholeEntry(faceRule, entry.sighting.face);
  return face && *face ? **face : 1;
}

bool isAnythingRead(const Position& position) {
  if (!position.zero.horizontal.empty() || !position.zero.vertical.empty()) return true;
  return std::ranges::any_of(
      position.readings, [](const Reading& row) { return !row.horizontal.empty() || !row.vertical.empty(); });
}

/// "pointing zero in face 2", from the field of a sighting.
QString zeroName(const std::string& zero) {
  PlannedSighting planned;
  planned.isZero = true;
  for (const ZeroSlot& slot : furtherZeros)
    if (zero == zeroField(slot)) {
      planned.face = slot.face;
      planned.isAfter = slot.isAfter;
    }
  return qText(sightingName(planned));
}

/// Collects objections to one reading.
class Doubts {
 public:
  Doubts(const Evaluation& evaluation, const Landing& landing, const InstrumentReading& reading,
         const TakenBefore& before)
      : m_evaluation(evaluation),
        m_session(evaluation.session),
        m_landing(landing),
        m_reading(reading),
        m_before(before),
        m_unit(circleUnitOf(evaluation.session)) {}

  QString question() {
    if (!m_landing.isChosen) doubtPosition();
    doubtSerial();
    if (!m_reading.reservation.empty()) doubtWarrant();
    doubtCorrections();
    doubtRepeat();
    doubtFace();
    doubtReplacement();
    doubtTarget();
    if (m_said.isEmpty()) return {};
    //: where a reading would go, and what was read: "0°: point 3", two angles and a face
    m_said.prepend(ReadingDoubts::tr("%1: %2 and %3 in %4 were read.")
                       .arg(entryText(m_session, m_landing.entry), shownAngle(m_reading.horizontal, m_unit),
                            shownAngle(m_reading.vertical, m_unit))
                       .arg(qText(faceName(m_reading.face))));
    return m_said.join(u' ');
  }

 private:
  void say(const QString& sentence) { m_said.append(sentence); }

  const Position& position() const { return m_session.positions[m_landing.position()]; }

  /// The position of the previous readings; absent if this reading belongs to the same position.
  std::optional<std::size_t> positionBefore() const {
    if (m_before.position())
      return m_before.position() != m_landing.position() ? m_before.position() : std::nullopt;
    if (isAnythingRead(position())) return std::nullopt;
    for (std::size_t i = 0; i < m_session.positions.size(); ++i)
      if (isAnythingRead(m_session.positions[i])) return i;
    return std::nullopt;
  }

  void doubtPosition() {
    const auto last = positionBefore();
    if (!last || *last >= m_session.positions.size()) return;
    const QString here = positionText(m_session, m_landing.position());
    say(ReadingDoubts::tr("The previous readings belong to %1, this reading to %2: has the axis been turned?")
            .arg(positionText(m_session, *last), here));
  }

  std::string lastOfRows(std::string Reading::*text) const {
    const auto& positions = m_session.positions;
    for (auto one = positions.rbegin(); one != positions.rend(); ++one)
      for (auto row = one->readings.rbegin(); row != one->readings.rend(); ++row)
        if (!((*row).*text).empty()) return (*row).*text;
    return {};
  }

  void doubtSerial() {
    if (m_reading.serial.empty()) return;
    const std::string& stated = m_session.instrument.serial;
    const bool isStated = m_before.serial().empty() && !stated.empty();
    const std::string usual = isStated                    ? stated
                              : m_before.serial().empty() ? lastOfRows(&Reading::instrumentSerial)
                                                          : m_before.serial();
    if (usual.empty() || usual == m_reading.serial) return;
    const QString was = shortLine(usual, longestSerial), is = shortLine(m_reading.serial, longestSerial);
    say(isStated ? ReadingDoubts::tr("The session's instrument has serial number %1, but this reading comes "
                                     "from serial number %2.")
                       .arg(was, is)
                 : ReadingDoubts::tr("The previous readings come from the instrument with serial number %1, "
                                     "but this one from serial number %2.")
                       .arg(was, is));
  }

  void doubtWarrant() {
    const QString why = visibleLine(qText(m_reading.reservation));
    say(m_reading.returnCode.empty()
            ? why
            : ReadingDoubts::tr("%1 (Return code %2.)").arg(why, qText(m_reading.returnCode)));
  }

  void doubtCorrections() {
    const std::string usual =
        m_before.corrections().empty() ? lastOfRows(&Reading::corrections) : m_before.corrections();
    const bool wasOff = !usual.empty() && usual.find("inclination") == std::string::npos;
    if (m_reading.isCompensated == false && m_before.isCompensated().value_or(!wasOff))
      say(ReadingDoubts::tr("The compensator is off: the readings contain the tilt of the instrument."));
    if (usual.empty() || m_reading.corrections.empty() || usual == m_reading.corrections) return;
    //: words such as "inclination collimation", or "none"
    say(ReadingDoubts::tr("The instrument corrected “%1” before and corrects “%2” now.")
            .arg(visibleLine(qText(usual)), visibleLine(qText(m_reading.corrections))));
  }

  bool isSame(const std::string& horizontal, const std::string& vertical, bool mayParse) const {
    if (horizontal == m_reading.horizontal && vertical == m_reading.vertical) return true;
    if (!mayParse || horizontal.empty() || vertical.empty()) return false;
    const auto a = parseAngle(horizontal), b = parseAngle(vertical);
    const auto isNear = [](Angle one, Angle other) {
      return std::abs(wrapped(one - other).arcseconds()) < sameWithin;
    };
    return a && b && isNear(*a, m_reading.horizontalAngle) && isNear(*b, m_reading.verticalAngle);
  }

  /// The name of the sighting in position `at` that already has the same angles; empty if none.
  QString placeOfSame(std::size_t at) const {
    const Position& one = m_session.positions[at];
    const bool mayParse = one.readings.size() <= mostCompared;
    std::vector<std::string> zeros{"pointing_zero"};
    for (const ZeroSlot& slot : furtherZeros) zeros.push_back(zeroField(slot));
    for (const std::string& zero : zeros)
      if (const ZeroSighting there = zeroAt(m_session, at, zero);
          isSame(there.horizontal, there.vertical, mayParse))
        return zeroName(zero);
    const auto row = std::ranges::find_if(one.readings, [&](const Reading& reading) {
      return isSame(reading.horizontal, reading.vertical, mayParse);
    });
    return row == one.readings.end() ? QString() : sightingText(*row);
  }

  void doubtRepeat() {
    for (std::size_t i = 0; i < m_session.positions.size(); ++i) {
      const QString where = placeOfSame(i);
      if (where.isEmpty()) continue;
      //: a position of the axis and a sighting there: "0°" and "Point 3"
      return say(
          ReadingDoubts::tr("The same angles are already at %1 (%2): did the instrument send them again?")
              .arg(positionText(m_session, i), where));
    }
    const auto isIt = [&](const InstrumentReading& one) {
      return isSame(one.horizontal, one.vertical, false);
    };
    if (std::ranges::any_of(m_before.readings(), isIt))
      say(ReadingDoubts::tr("The same angles came before: did the instrument send them again?"));
  }

  void doubtFace() {
    if (m_landing.isProposed) return;
    const int face = expectedFace(m_landing.entry);
    if (face != m_reading.face)
      say(ReadingDoubts::tr("The vertical circle shows %1, but %2 is asked for.")
              .arg(qText(faceName(m_reading.face)), qText(faceName(face))));
  }

  /// The angles already entered at the landing, which the reading replaces; empty if there are none.
  QString overwritten() const {
    if (!m_landing.row) {
      const ZeroSighting zero = zeroAt(m_session, m_landing.position(), m_landing.zero);
      return zero.horizontal.empty() && zero.vertical.empty()
                 ? QString()
                 : ReadingDoubts::tr("%1 and %2")
                       .arg(shownAngle(zero.horizontal, m_unit), shownAngle(zero.vertical, m_unit));
    }
    if (*m_landing.row >= position().readings.size()) return {};
    const Reading& row = position().readings[*m_landing.row];
    if (row.horizontal.empty() && row.vertical.empty()) return {};
    if (row.horizontal.empty() || row.vertical.empty())
      return shownAngle(row.horizontal.empty() ? row.vertical : row.horizontal, m_unit);
    return ReadingDoubts::tr("%1 and %2")
        .arg(shownAngle(row.horizontal, m_unit), shownAngle(row.vertical, m_unit));
  }

  void doubtReplacement() {
    if (const QString there = overwritten(); !there.isEmpty())
      say(m_landing.row ? ReadingDoubts::tr("%1 is already entered there and would be replaced.").arg(there)
                        : ReadingDoubts::tr("The %1 is already entered (%2) and would be replaced.")
                              .arg(zeroName(m_landing.zero), there));
  }

  /// The reading that the protocol predicts, else the one that the rows predict; absent if neither does.
  std::optional<ExpectedReading> expected() const {
    const EntryToCome& entry = m_landing.entry;
    const Guide* guide = m_evaluation.guide.get();
    if (guide && guide->problem.empty())
      for (std::size_t i = 0; i < guide->progress.sightings.size() && i < guide->expected.size(); ++i)
        if (isExpected(guide->progress.sightings[i])) return guide->expected[i];
    return entry.position < m_evaluation.next.size() ? expectedOf(m_evaluation, entry) : std::nullopt;
  }

  bool isExpected(const FollowedSighting& followed) const {
    const EntryToCome& entry = m_landing.entry;
    const PlannedSighting& planned = followed.planned;
    if (followed.position != entry.position || planned.isZero == entry.zero.empty()) return false;
    if (planned.isZero) return planned.face == entry.zeroFace && planned.isAfter == entry.isAfter;
    const auto point = wholeEntry(pointRule, entry.sighting.point);
    const auto round = wholeEntry(roundRule, entry.sighting.round);
    return point && round && *point == planned.point && *round == planned.round &&
           expectedFace(entry) == planned.face;
  }

  void doubtTarget() {
    if (m_landing.isProposed)
      return say(ReadingDoubts::tr(
                     "The instrument points at the pointing zero: if accepted, the reading becomes the %1.")
                     .arg(zeroName(m_landing.zero)));
    if (const auto there = expected()) {
      const auto kind = verticalCircleEntry(m_session.geometry.verticalCircle);
      const FaceOneReading wanted =
          inFaceOne(there->horizontal, there->vertical, expectedFace(m_landing.entry),
                    kind ? *kind : VerticalCircle::Zenith);
      if (isFar(inFaceOne(m_reading, m_session), wanted, there->tolerance))
        say(ReadingDoubts::tr("About %1 and %2 were expected: is it the right target?")
                .arg(coarseAngleText(there->horizontal, m_unit), coarseAngleText(there->vertical, m_unit)));
      return;
    }
    m_landing.row ? doubtZeroInRow() : doubtZero();
  }

  /// Objects to a reading for a row if the instrument points at the pointing zero.
  void doubtZeroInRow() {
    if (looksAt(m_reading, m_session, m_landing.position(), zeroTolerance))
      say(ReadingDoubts::tr("The instrument points at the pointing zero: is it the right target?"));
  }

  void doubtZero() {
    for (std::size_t i = 0; i < m_session.positions.size(); ++i) {
      const PointingZero& zero = m_session.positions[i].zero;
      const auto horizontal = parseAngle(zero.horizontal), vertical = parseAngle(zero.vertical);
      if (!horizontal || !vertical || looksAt(m_reading, m_session, i, zeroTolerance)) continue;
      return say(ReadingDoubts::tr("The pointing zero of %1 is %2 and %3: is it the right target?")
                     .arg(positionText(m_session, i), shownAngle(zero.horizontal, m_unit),
                          shownAngle(zero.vertical, m_unit)));
    }
  }

  const Evaluation& m_evaluation;
  const Session& m_session;
  const Landing& m_landing;
  const InstrumentReading& m_reading;
  const TakenBefore& m_before;
  const CircleUnit m_unit;
  QStringList m_said;
};

}  // namespace

void TakenBefore::add(const InstrumentReading& reading, std::size_t position) {
  m_position = position;
  if (!reading.serial.empty()) m_serial = reading.serial;
  if (!reading.corrections.empty()) m_corrections = reading.corrections;
  if (reading.isCompensated) m_isCompensated = reading.isCompensated;
  m_readings.push_back(reading);
  if (m_readings.size() > mostKept) m_readings.pop_front();
}

QString readingQuestion(const Evaluation& evaluation, const Landing& landing,
                        const InstrumentReading& reading, const TakenBefore& before) {
  return Doubts(evaluation, landing, reading, before).question();
}

QString placelessQuestion(const Evaluation& evaluation, const InstrumentReading& reading) {
  const CircleUnit unit = circleUnitOf(evaluation.session);
  const Guide* guide = evaluation.guide.get();
  const bool isLacking = guide && guide->problem.empty() && guide->progress.next &&
                         !guide->progress.sightings[*guide->progress.next].position;
  const QString horizontal = shownAngle(reading.horizontal, unit),
                vertical = shownAngle(reading.vertical, unit);
  if (isLacking)
    return ReadingDoubts::tr(
               "A reading came, %1 and %2, but the session lacks the position that the protocol asks for. "
               "Add the position, then take the reading.")
        .arg(horizontal, vertical);
  return ReadingDoubts::tr(
             "A reading came, %1 and %2, but all readings are already taken. Add a row, or choose a row to "
             "be read again, then take the reading.")
      .arg(horizontal, vertical);
}

}  // namespace alidade::ui
