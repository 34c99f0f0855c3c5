#include "core/connection/geocom_talk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/connection/circle_text.h"
#include "core/session/face.h"

namespace alidade {

namespace {

constexpr int tiltDecimals = 2;  // 0.01″, the resolution of compensators
constexpr std::size_t anglesCount = 9, plainCount = 2, switchesCount = 4;
constexpr std::array<const char*, switchesCount> switchNames = {"inclination", "standing_axis", "collimation",
                                                                "tilting_axis"};
constexpr double largestRadians = 1000;  // instruments count turns, but never this many

std::optional<Angle> radiansOf(const std::string& text) {
  const Result<double> number = parseNumber(text);
  if (!number || std::abs(*number) > largestRadians) return std::nullopt;
  return Angle::fromRadians(*number);
}

Angle asWritten(Angle angle) {
  constexpr int decimals = 3;  // as `circleText`
  return wrappedAsWritten(angle, decimals, Angle::fromDegrees(180));
}

/// Did the instrument answer that it does not know the question?
bool isUnknown(std::optional<int> code) {
  return code && (*code == geocom::notImplemented || *code == geocom::notAvailable);
}

std::string arcsecondsText(Angle angle) {
  return fixedText(angle.arcseconds(), tiltDecimals);
}

}  // namespace

void GeoComTalk::onBegin(Milliseconds now, TalkStep& step) {
  m_questions = {{geocom::null, Need::Wakes}, {geocom::null, Need::Wakes}, {geocom::doublePrecision},
                 {geocom::instrumentName},    {geocom::instrumentNumber},  {geocom::softwareVersion},
                 {geocom::temperature}};
  ask(now, step);
}

void GeoComTalk::onTake(Milliseconds now, TalkStep& step) {
  if (m_isTaking)
    return step.remarks.push_back(
        Phrase::of("A reading is already being taken: no second one is requested."));
  m_isTaking = true;
  m_hasAngles = false;
  m_reading = {};
  m_isCompensated.reset();
  const bool isIdle = m_questions.empty();
  if (!m_isAwake && isIdle) m_questions.push_back({geocom::null, Need::Wakes});
  for (const int rpc : {geocom::instrumentNumber, geocom::corrections, geocom::compensator})
    if (m_notAnswered.count(rpc) == 0) m_questions.push_back({rpc});
  const bool isPlain = m_notAnswered.count(geocom::angles) > 0;
  m_questions.push_back({isPlain ? geocom::plainAngles : geocom::angles, Need::Angles});
  if (isIdle) ask(now, step);
}

/// Sends the first question, with a new transaction number.
void GeoComTalk::ask(Milliseconds now, TalkStep& step) {
  m_askAt.reset();
  m_waitsFor.reset();
  if (m_questions.empty()) return;
  Question& question = m_questions.front();
  ++question.attempts;
  m_transaction = m_transaction % geocom::lastTransaction + 1;
  m_waitsFor = m_transaction;
  m_deadline = now + (question.need == Need::Angles ? m_times.answerWithin : m_times.wakeWithin);
  GeoComQuestion message{.rpc = question.rpc, .transaction = m_transaction};
  // 1: the instrument itself chooses between the compensator's plane and a measurement of the tilts.
  if (question.rpc == geocom::angles || question.rpc == geocom::plainAngles) message.parameters = {"1"};
  send(geoComLine(message), step);
}

/// Repeats the question after a lost or damaged answer; gives up after the last attempt.
void GeoComTalk::askAgain(Milliseconds now, TalkStep& step) {
  const Question& question = m_questions.front();
  const int most = question.need == Need::Optional ? std::min(2, m_times.attempts) : m_times.attempts;
  if (question.attempts < most) return ask(now, step);
  giveUp(std::nullopt, now, step);
}

void GeoComTalk::next(Milliseconds now, TalkStep& step) {
  m_questions.pop_front();
  m_wasSpoiled = false;
  m_waitsFor.reset();
  m_askAt.reset();
  if (m_isTaking && m_hasAngles) finishReading(step);
  if (m_questions.empty() && !m_isIdentified && m_isAwake) step.isIdentified = m_isIdentified = true;
  ask(now, step);
}

void GeoComTalk::onLine(const std::string& line, Milliseconds now, TalkStep& step) {
  const auto answer = geoComAnswer(line);
  if (!answer)
    return step.remarks.push_back(
        Phrase::of("This is no GeoCOM answer and was skipped: %1", shownLine(line.substr(0, 60))));
  if (!m_waitsFor || answer->transaction != *m_waitsFor)
    return step.remarks.push_back(
        Phrase::of("An answer came late or twice and was dropped: %1", shownLine(line.substr(0, 60))));
  if (!answer->isSound)
    return askAgainAsSpoiled(
        Phrase::of("The check sum of an answer does not match its text; the answer is requested again: %1",
                   shownLine(line.substr(0, 60))),
        now, step);
  use(*answer, now, step);
}

void GeoComTalk::askAgainAsSpoiled(const std::string& remark, Milliseconds now, TalkStep& step) {
  step.remarks.push_back(remark);
  m_wasSpoiled = true;
  askAgain(now, step);
}

void GeoComTalk::use(const GeoComAnswer& answer, Milliseconds now, TalkStep& step) {
  Question& question = m_questions.front();
  const int code = answer.communicationCode != geocom::done ? answer.communicationCode : answer.returnCode;
  if (isBusy(code) && ++question.busy <= m_times.busyAttempts) {
    if (question.busy == 1)
      step.remarks.push_back(geoComSentence(code) + " " + Phrase::of("The request is sent again."));
    question.attempts = 0;
    m_waitsFor.reset();
    m_askAt = now + m_times.busyPause;
    return;
  }
  const bool isAngles = question.need == Need::Angles;
  if (isAngles ? !hasAngles(code) : code != geocom::done) return giveUp(code, now, step);
  if (!isWhole(question.rpc, answer) || (isAngles && !takeAngles(answer, step)))
    return askAgainAsSpoiled(Phrase::of("An answer was corrupted in transmission and is requested again: %1",
                                        shownLine(geoComLine(answer).substr(0, 60))),
                             now, step);
  m_isAwake = true;
  if (!isAngles) takeIdentity(question.rpc, answer);
  next(now, step);
}

/// Does the answer have the number and kind of parameters that this question requires?
bool GeoComTalk::isWhole(int rpc, const GeoComAnswer& answer) {
  const std::vector<std::string>& values = answer.parameters;
  const auto isNumber = [](const std::string& text) { return static_cast<bool>(parseNumber(text)); };
  switch (rpc) {
    case geocom::angles:
      return values.size() == anglesCount && std::all_of(values.begin(), values.end(), isNumber);
    case geocom::plainAngles:
      return values.size() == plainCount && std::all_of(values.begin(), values.end(), isNumber);
    case geocom::corrections:
      return values.size() == switchesCount && std::all_of(values.begin(), values.end(), isNumber);
    case geocom::null:
      return values.empty();
    default:
      return !values.empty();
  }
}

/// Fills `m_reading` from an answer with angles. False if one of its values is not an angle.
bool GeoComTalk::takeAngles(const GeoComAnswer& answer, TalkStep& step) {
  const std::vector<std::string>& values = answer.parameters;
  const auto horizontal = radiansOf(values[0]), vertical = radiansOf(values[1]);
  if (!horizontal || !vertical) return false;
  const Angle zenith = asWritten(*vertical);
  m_reading.horizontalAngle = asWritten(*horizontal);
  m_reading.verticalAngle = onCircle(zenith, m_circles.vertical);
  m_reading.horizontal = circleText(m_reading.horizontalAngle, m_circles.unit);
  m_reading.vertical = circleText(m_reading.verticalAngle, m_circles.unit);
  m_reading.face = isFaceTwo(zenith, VerticalCircle::Zenith) ? 2 : 1;
  m_reading.returnCode = std::to_string(answer.returnCode);
  m_reading.reservation = isGuaranteed(answer.returnCode) ? "" : geoComSentence(answer.returnCode);
  m_reading.isCompensated = m_isCompensated;
  if (values.size() == anglesCount) {
    const auto accuracy = radiansOf(values[2]), cross = radiansOf(values[4]), length = radiansOf(values[5]);
    if (!accuracy || !cross || !length) return false;
    m_reading.accuracyArcsec = arcsecondsText(*accuracy);
    if (m_isCompensated.value_or(true)) {
      m_reading.tiltCrossArcsec = arcsecondsText(*cross);
      m_reading.tiltLengthArcsec = arcsecondsText(*length);
    }
    if (const Result<int> face = parseWhole(values[8]); face && *face + 1 != m_reading.face)
      step.remarks.push_back(
          Phrase::of("The instrument reports %1, but its vertical circle shows %2: the circle is used.",
                     faceName(*face + 1), faceName(m_reading.face)));
  }
  if (answer.returnCode != geocom::done) step.remarks.push_back(geoComSentence(answer.returnCode));
  m_hasAngles = true;
  return true;
}

void GeoComTalk::takeIdentity(int rpc, const GeoComAnswer& answer) {
  const std::vector<std::string>& values = answer.parameters;
  switch (rpc) {
    case geocom::instrumentName:
      m_identity.name = values[0];
      break;
    case geocom::instrumentNumber:
      takeSerial(values[0]);
      break;
    case geocom::softwareVersion:
      for (const std::string& part : values)
        m_identity.software += (m_identity.software.empty() ? "" : ".") + part;
      break;
    case geocom::temperature:
      m_identity.temperatureC = values[0];
      break;
    case geocom::compensator:
      m_isCompensated = values[0] != "0";
      break;
    case geocom::corrections: {
      std::string& words = m_reading.corrections;
      for (std::size_t i = 0; i < switchesCount; ++i)
        if (values[i] != "0") words += (words.empty() ? "" : " ") + std::string(switchNames.at(i));
      if (words.empty()) words = "none";
      break;
    }
    default:
      break;
  }
}

/// Keeps the serial number. If it changed, another instrument is on the cable: its name is requested too.
void GeoComTalk::takeSerial(const std::string& serial) {
  const bool isOther = !m_identity.serial.empty() && m_identity.serial != serial;
  m_identity.serial = serial;
  if (!isOther) return;
  m_isIdentified = false;
  m_identity.name.clear();
  m_questions.push_back({geocom::instrumentName});
}

/// Skips an optional question, for good if it was refused. If RPC 2003 is unknown, asks for the angles
/// without tilts (RPC 2107). Otherwise ends the reading or contact. `code`: return code; absent: no answer.
void GeoComTalk::giveUp(std::optional<int> code, Milliseconds now, TalkStep& step) {
  const Question question = m_questions.front();
  if (question.need == Need::Optional) {
    if (code) m_notAnswered.insert(question.rpc);
    return next(now, step);
  }
  if (question.rpc == geocom::angles && isUnknown(code)) {
    m_notAnswered.insert(question.rpc);
    m_questions.front() = {geocom::plainAngles, Need::Angles};
    return ask(now, step);
  }
  const std::string why =
      code           ? geoComSentence(*code)
      : m_wasSpoiled ? Phrase::of("The answers of the instrument were corrupted %1 times.", question.attempts)
                     : Phrase::of("The instrument failed to answer %1 times.", question.attempts);
  step.remarks.push_back(m_isTaking ? Phrase::of("%1 No reading was taken; sight again.", why)
                                    : Phrase::of("%1 Check that the instrument is on and set to GeoCOM at "
                                                 "this baud rate, and that the port is right.",
                                                 why));
  m_questions.clear();
  m_waitsFor.reset();
  m_askAt.reset();
  m_wasSpoiled = false;
  m_isTaking = false;
  m_isAwake = m_isAwake && code.has_value();
}

void GeoComTalk::finishReading(TalkStep& step) {
  m_reading.serial = m_identity.serial;
  step.readings.push_back(m_reading);
  m_isTaking = m_hasAngles = false;
}

void GeoComTalk::onTick(Milliseconds now, TalkStep& step) {
  if (m_askAt && now >= *m_askAt) return ask(now, step);
  if (m_waitsFor && now >= m_deadline) askAgain(now, step);
}

std::optional<Milliseconds> GeoComTalk::onWakeAt() const {
  if (m_askAt) return m_askAt;
  if (m_waitsFor) return m_deadline;
  return std::nullopt;
}

}  // namespace alidade
