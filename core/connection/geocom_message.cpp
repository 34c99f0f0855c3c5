#include "core/connection/geocom_message.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "core/base/phrase.h"

namespace alidade {

namespace {

std::optional<int> wholeOf(std::string_view text) {
  int number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (text.empty() || error != std::errc() || stop != end) return std::nullopt;
  return number;
}

/// The parts separated by commas outside quotes; none for an empty text.
std::vector<std::string> partsOf(std::string_view text) {
  std::vector<std::string> parts;
  if (text.empty()) return parts;
  parts.emplace_back();
  bool isQuoted = false;
  for (const char c : text) {
    if (c == '"') {
      isQuoted = !isQuoted;
    } else if (c == ',' && !isQuoted) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ",") + part;
  return text;
}

struct Message {
  std::vector<int> heads;  ///< numbers before the colon, up to three; the third is a check sum
  std::string_view rest;   ///< text after the colon
  bool isSound = true;     ///< the check sum is correct, or there is none
};

/// Is the third number before the colon the check sum of the rest of the line?
bool fitsItsChecksum(std::string_view message, std::size_t colon, int checksum) {
  const std::size_t comma = message.rfind(',', colon);
  const std::string without = std::string(message.substr(0, comma)) + std::string(message.substr(colon));
  return geoComChecksum(without) == checksum;
}

/// The message from the last `mark` of a line on, without the noise before it.
std::optional<Message> messageFrom(std::string_view mark, std::string_view line) {
  const std::size_t at = line.rfind(mark);
  if (at == std::string_view::npos) return std::nullopt;
  line.remove_prefix(at);
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  Message message{{}, line.substr(colon + 1)};
  for (const std::string& part : partsOf(line.substr(mark.size(), colon - mark.size()))) {
    const auto number = wholeOf(part);
    if (!number || *number < 0) return std::nullopt;
    message.heads.push_back(*number);
  }
  if (message.heads.size() > 3) return std::nullopt;
  if (message.heads.size() == 3) message.isSound = fitsItsChecksum(line, colon, message.heads[2]);
  return message;
}

constexpr std::array<std::pair<int, const char*>, 16> sentences = {{
    {geocom::done, PHRASE_LATER("Phrase", "Done.")},
    {2, PHRASE_LATER("Phrase", "The instrument does not accept this parameter.")},
    {geocom::notImplemented, PHRASE_LATER("Phrase", "The instrument does not know this command.")},
    {geocom::systemBusy, PHRASE_LATER("Phrase", "The instrument is busy.")},
    {geocom::notAvailable, PHRASE_LATER("Phrase", "The instrument has no answer to this question.")},
    {geocom::notFullyCorrected,
     PHRASE_LATER("Phrase", "The angles are not fully corrected: is the compensator within its range?")},
    {geocom::accuracyUncertain,
     PHRASE_LATER("Phrase", "The instrument reports an uncertain accuracy: is it levelled and at rest?")},
    {geocom::anglesOnly, PHRASE_LATER("Phrase", "The angles are good; there is no distance.")},
    {geocom::anglesNotFullyCorrected,
     PHRASE_LATER("Phrase", "The angles are not fully corrected: is the compensator within its range?")},
    {geocom::anglesUncertain,
     PHRASE_LATER("Phrase", "The instrument reports uncertain angles: is it levelled and at rest?")},
    {1290, PHRASE_LATER("Phrase", "The instrument could not read its circles: level it and try again.")},
    {geocom::busy, PHRASE_LATER("Phrase", "The instrument is busy measuring.")},
    {geocom::cannotSend, PHRASE_LATER("Phrase", "The instrument cannot send: its buffer may be full.")},
    {geocom::timedOut, PHRASE_LATER("Phrase", "The instrument reports an internal timeout.")},
    {3085, PHRASE_LATER("Phrase", "The instrument failed to answer.")},
    {11, PHRASE_LATER("Phrase", "The instrument is switching off.")},
}};

}  // namespace

std::string geoComLine(const GeoComQuestion& question) {
  const std::string transaction = question.transaction ? "," + std::to_string(*question.transaction) : "";
  return "%R1Q," + std::to_string(question.rpc) + transaction + ":" + joined(question.parameters);
}

std::string geoComLine(const GeoComAnswer& answer) {
  std::string line = "%R1P," + std::to_string(answer.communicationCode) + "," +
                     std::to_string(answer.transaction) + ":" + std::to_string(answer.returnCode);
  for (const std::string& parameter : answer.parameters) line += "," + parameter;
  return line;
}

std::optional<GeoComQuestion> geoComQuestion(std::string_view line) {
  const auto message = messageFrom("%R1Q,", line);
  if (!message || message->heads.empty()) return std::nullopt;
  GeoComQuestion question{.rpc = message->heads[0], .parameters = partsOf(message->rest)};
  if (message->heads.size() > 1) question.transaction = message->heads[1];
  return question;
}

std::optional<GeoComAnswer> geoComAnswer(std::string_view line) {
  const auto message = messageFrom("%R1P,", line);
  if (!message || message->heads.size() < 2) return std::nullopt;
  std::vector<std::string> parts = partsOf(message->rest);
  const auto code = parts.empty() ? std::nullopt : wholeOf(parts.front());
  if (!code) return std::nullopt;
  parts.erase(parts.begin());
  return GeoComAnswer{message->heads[0], message->heads[1], *code, std::move(parts), message->isSound};
}

int geoComChecksum(std::string_view text) {
  constexpr unsigned reflected = 0xa001;
  unsigned sum = 0;
  for (const char c : text) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1U) != 0 ? (sum >> 1U) ^ reflected : sum >> 1U;
  }
  return static_cast<int>(sum);
}

bool hasAngles(int returnCode) {
  using namespace geocom;
  constexpr std::array good = {done,       notFullyCorrected,       accuracyUncertain,
                               anglesOnly, anglesNotFullyCorrected, anglesUncertain};
  return std::find(good.begin(), good.end(), returnCode) != good.end();
}

bool isGuaranteed(int returnCode) {
  return returnCode == geocom::done || returnCode == geocom::anglesOnly;
}

bool isBusy(int returnCode) {
  return returnCode == geocom::busy || returnCode == geocom::systemBusy || returnCode == geocom::timedOut ||
         returnCode == geocom::cannotSend;
}

std::string geoComSentence(int returnCode) {
  const auto* const known = std::find_if(sentences.begin(), sentences.end(),
                                         [returnCode](const auto& one) { return one.first == returnCode; });
  return known != sentences.end() ? Phrase::of(known->second)
                                  : Phrase::of("The instrument answers with the return code %1.", returnCode);
}

}  // namespace alidade
