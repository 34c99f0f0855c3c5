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

/// Parted by commas outside of quotes; nothing of nothing.
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

/// Behind the last `mark` of a line, noise before it being none of it: its heads as numbers, up to three, and
/// what stands behind the colon.
std::optional<std::pair<std::vector<int>, std::string_view>> headBehind(std::string_view mark,
                                                                        std::string_view line) {
  const std::size_t at = line.rfind(mark);
  if (at == std::string_view::npos) return std::nullopt;
  line.remove_prefix(at + mark.size());
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  std::vector<int> heads;
  for (const std::string& part : partsOf(line.substr(0, colon))) {
    const auto number = wholeOf(part);
    if (!number || *number < 0) return std::nullopt;
    heads.push_back(*number);
  }
  if (heads.size() > 3) return std::nullopt;
  return std::pair(heads, line.substr(colon + 1));
}

constexpr std::array<std::pair<int, const char*>, 16> sentences = {{
    {geocom::done, PHRASE_LATER("Phrase", "Done.")},
    {2, PHRASE_LATER("Phrase", "The instrument takes no such parameter.")},
    {geocom::notImplemented, PHRASE_LATER("Phrase", "The instrument does not know this question.")},
    {geocom::systemBusy, PHRASE_LATER("Phrase", "The instrument is busy.")},
    {geocom::notAvailable, PHRASE_LATER("Phrase", "The instrument has no answer to this question.")},
    {geocom::notFullyCorrected,
     PHRASE_LATER("Phrase", "The angles are not fully corrected: is the compensator within its range?")},
    {geocom::accuracyUncertain,
     PHRASE_LATER("Phrase", "The instrument does not vouch for its accuracy: is it levelled and at rest?")},
    {geocom::anglesOnly, PHRASE_LATER("Phrase", "The angles are good; there is no distance.")},
    {geocom::anglesNotFullyCorrected,
     PHRASE_LATER("Phrase", "The angles are not fully corrected: is the compensator within its range?")},
    {geocom::anglesUncertain,
     PHRASE_LATER("Phrase", "The instrument does not vouch for its angles: is it levelled and at rest?")},
    {1290, PHRASE_LATER("Phrase", "The instrument could not read its circles: level it and try again.")},
    {geocom::busy, PHRASE_LATER("Phrase", "The instrument is busy measuring.")},
    {geocom::cannotSend, PHRASE_LATER("Phrase", "The instrument cannot send: its buffer may be full.")},
    {geocom::timedOut, PHRASE_LATER("Phrase", "The instrument gave up waiting within itself.")},
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
  const auto head = headBehind("%R1Q,", line);
  if (!head || head->first.empty()) return std::nullopt;
  GeoComQuestion question{.rpc = head->first[0], .parameters = partsOf(head->second)};
  if (head->first.size() > 1) question.transaction = head->first[1];
  return question;
}

std::optional<GeoComAnswer> geoComAnswer(std::string_view line) {
  const auto head = headBehind("%R1P,", line);
  if (!head || head->first.size() < 2) return std::nullopt;
  std::vector<std::string> parts = partsOf(head->second);
  const auto code = parts.empty() ? std::nullopt : wholeOf(parts.front());
  if (!code) return std::nullopt;
  parts.erase(parts.begin());
  return GeoComAnswer{head->first[0], head->first[1], *code, std::move(parts)};
}

bool hasAngles(int returnCode) {
  using namespace geocom;
  constexpr std::array good = {done,       notFullyCorrected,       accuracyUncertain,
                               anglesOnly, anglesNotFullyCorrected, anglesUncertain};
  return std::find(good.begin(), good.end(), returnCode) != good.end();
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
