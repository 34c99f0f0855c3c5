#include "core/connection/gsi_talk.h"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/angle_text.h"
#include "core/base/phrase.h"
#include "core/connection/gsi_information.h"
#include "core/exchange/gsi_word.h"
#include "core/session/face.h"
#include "core/session/row_fields.h"

namespace alidade {

namespace {

constexpr int pointWord = 11, serialWord = 12, horizontalWord = 21, verticalWord = 22;
constexpr const char* acknowledgement = "?";
constexpr const char* measureBoth = "GET/M/WI21/WI22";
constexpr const char* askSerial = "GET/I/WI12";

/// The block from the last * on, without noise or an incomplete block before it; else the whole line.
std::string blockIn(const std::string& line) {
  const std::size_t star = line.rfind('*');
  return star != std::string::npos && looksLikeGsi(line.substr(star)) ? line.substr(star) : line;
}

const GsiWord* wordIn(const std::vector<GsiWord>& words, int index) {
  const auto found = std::ranges::find(words, index, &GsiWord::index);
  return found == words.end() ? nullptr : &*found;
}

/// The circle reading of a word. `text` receives its text, which is checked like typed input.
Result<Angle> circleOf(const GsiWord& word, const RowField& field, VerticalCircle circle, std::string& text) {
  const auto angle = gsiAngle(word, 0);
  if (const auto* problem = std::get_if<LineProblem>(&angle)) return Problem{problem->what};
  text = std::get<std::string>(angle);
  if (auto problem = entryProblem(field, text, circle)) return *std::move(problem);
  return parseAngle(text);
}

void takeInformation(const GsiWord& horizontalCircle, const GsiWord& verticalCircle,
                     InstrumentReading& reading) {
  const GsiInformation horizontal = gsiInformation(horizontalCircle),
                       vertical = gsiInformation(verticalCircle);
  reading.isCompensated = vertical.isCompensated ? vertical.isCompensated : horizontal.isCompensated;
  reading.corrections = gsiCorrections(horizontal, vertical);
  reading.reservation = gsiReservation(horizontal, vertical);
}

}  // namespace

Result<InstrumentReading> gsiReading(const std::string& block, VerticalCircle circle) {
  const auto parsed = gsiWords({0, block});
  if (const auto* problem = std::get_if<LineProblem>(&parsed)) return Problem{problem->what};
  const auto& words = std::get<std::vector<GsiWord>>(parsed);
  const GsiWord *horizontal = wordIn(words, horizontalWord), *vertical = wordIn(words, verticalWord);
  if (!horizontal || !vertical)
    return Problem{
        Phrase::of("a block needs both circles, words 21 and 22: put both into the recording mask of the "
                   "instrument, and sight again")};
  InstrumentReading reading;
  const Result<Angle> alpha =
      circleOf(*horizontal, rowField(&Reading::horizontal), circle, reading.horizontal);
  if (!alpha) return alpha.problem();
  const Result<Angle> beta = circleOf(*vertical, rowField(&Reading::vertical), circle, reading.vertical);
  if (!beta) return beta.problem();
  reading.horizontalAngle = *alpha;
  reading.verticalAngle = *beta;
  reading.face = isFaceTwo(*beta, circle) ? 2 : 1;
  if (const GsiWord* point = wordIn(words, pointWord)) reading.point = gsiText(*point);
  if (const GsiWord* serial = wordIn(words, serialWord)) reading.serial = gsiText(*serial);
  takeInformation(*horizontal, *vertical, reading);
  return reading;
}

void GsiTalk::onBegin(Milliseconds now, TalkStep& step) {
  m_serialUntil = now + m_times.wakeWithin;
  send(askSerial, step);
}

void GsiTalk::onTake(Milliseconds now, TalkStep& step) {
  if (m_readingUntil)
    return step.remarks.push_back(
        Phrase::of("A reading is already being taken: no second one is requested."));
  m_readingUntil = now + m_times.answerWithin;
  send(measureBoth, step);
}

std::optional<Milliseconds> GsiTalk::onWakeAt() const {
  if (m_readingUntil && m_serialUntil) return std::min(*m_readingUntil, *m_serialUntil);
  return m_readingUntil ? m_readingUntil : m_serialUntil;
}

void GsiTalk::onTick(Milliseconds now, TalkStep& step) {
  if (m_serialUntil && now >= *m_serialUntil) m_serialUntil.reset();
  if (!m_readingUntil || now < *m_readingUntil) return;
  m_readingUntil.reset();
  step.remarks.push_back(Phrase::of(
      "The instrument did not answer. No reading was taken; sight again, or record on the instrument. Check "
      "that the instrument is set to GSI at this baud rate, and that the port is right."));
}

void GsiTalk::onLine(const std::string& line, Milliseconds now, TalkStep& step) {
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == std::string::npos) return;
  const std::string text = line.substr(first);
  if (text == "?") return;  // acknowledges a setting
  if (text[0] == '@') return takeCode(text, step);
  takeBlock(blockIn(text), now, step);
}

/// Takes the answer to the question for the serial number; false for any other line.
bool GsiTalk::takeSerial(const std::string& line, TalkStep& step) {
  if (!m_serialUntil) return false;
  const auto parsed = gsiWords({0, line});
  const auto* words = std::get_if<std::vector<GsiWord>>(&parsed);
  const GsiWord* serial = words ? wordIn(*words, serialWord) : nullptr;
  if (!serial || wordIn(*words, horizontalWord)) return false;
  m_serialUntil.reset();
  m_identity.serial = gsiText(*serial);
  step.isIdentified = true;
  return true;
}

/// Reports an error or warning code. In answer to the question for the serial number a code is ignored: some
/// instruments do not state the number.
void GsiTalk::takeCode(const std::string& code, TalkStep& step) {
  if (std::exchange(m_serialUntil, std::nullopt)) return;
  const std::string shown = shownLine(code.substr(0, 40));
  const bool isError = code.size() > 1 && code[1] == 'E';
  const std::string report =
      isError ? Phrase::of("The instrument reports an error: %1. Look at its display.", shown)
              : Phrase::of("The instrument warns: %1. Look at its display.", shown);
  const bool wasRequested = m_readingUntil.has_value();
  m_readingUntil.reset();
  step.remarks.push_back(wasRequested ? Phrase::of("%1 No reading was taken; sight again.", report) : report);
}

bool GsiTalk::wasTaken(const std::string& line, Milliseconds now) const {
  return line == m_lastBlock && now < m_lastAt + m_times.repeatWithin;
}

void GsiTalk::takeBlock(const std::string& line, Milliseconds now, TalkStep& step) {
  const std::string shown = shownLine(line.substr(0, 60));
  if (!looksLikeGsi(line))
    return step.remarks.push_back(Phrase::of("This is no GSI block and was skipped: %1", shown));
  if (takeSerial(line, step)) return;
  const Result<InstrumentReading> reading = gsiReading(line, m_circles.vertical);
  if (!reading)  // the instrument repeats a block that is not acknowledged
    return step.remarks.push_back(
        Phrase::of("A block was not accepted: %1. The instrument sends it again, or reports an error.",
                   reading.problem().what));
  const bool isAnswer = m_readingUntil.has_value();
  const bool isAgain = !isAnswer && wasTaken(line, now);
  if (!isAnswer) send(acknowledgement, step);
  m_readingUntil.reset();
  m_lastBlock = line;
  m_lastAt = now;
  if (isAgain)
    return step.remarks.push_back(Phrase::of("A block was received twice and used once: %1", shown));
  step.readings.push_back(*reading);
  if (reading->serial.empty()) step.readings.back().serial = m_identity.serial;
}

}  // namespace alidade
