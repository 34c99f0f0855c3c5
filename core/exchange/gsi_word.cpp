#include "core/exchange/gsi_word.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "core/base/limits.h"
#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

constexpr std::size_t dataAt = 7, shortData = 8, longData = 16;
constexpr std::uint64_t mostUnits = 1'000'000'000;  // 9 digits: ten times what any circle reads

bool isInformation(char c) {
  return isDigit(c) || c == '.';
}

bool beginsWord(std::string_view text) {
  return text.size() >= dataAt && isDigit(text[0]) && isDigit(text[1]) &&
         std::all_of(text.begin() + 2, text.begin() + 6, isInformation) && (text[6] == '+' || text[6] == '-');
}

bool endsAt(std::string_view text, std::size_t at) {
  return text.size() == at || (text.size() > at && (text[at] == ' ' || text[at] == '\t'));
}

/// How many characters of data the word at the start of `text` has; 0 where neither width fits.
std::size_t dataWidth(std::string_view text, bool marked) {
  if (!marked && endsAt(text, dataAt + shortData)) return shortData;
  return endsAt(text, dataAt + longData) ? longData : 0;
}

std::string padded(std::uint64_t number, std::size_t width) {
  const std::string digits = std::to_string(number);
  return std::string(width > digits.size() ? width - digits.size() : 0, '0') + digits;
}

std::string withDecimals(std::uint64_t units, std::uint64_t perWhole, std::size_t decimals) {
  return std::to_string(units / perWhole) + "." + padded(units % perWhole, decimals);
}

std::string sexagesimal(std::uint64_t units) {
  const std::uint64_t tenths = units % 1000;
  return std::to_string(units / 100'000) + "°" + padded(units / 1000 % 100, 2) + "'" +
         padded(tenths / 10, 2) + "." + std::to_string(tenths % 10) + "\"";
}

constexpr std::array<std::pair<int, const char*>, 26> wordNames = {{
    {11, PHRASE_LATER("Phrase", "point")},
    {12, PHRASE_LATER("Phrase", "serial number")},
    {13, PHRASE_LATER("Phrase", "instrument type")},
    {16, PHRASE_LATER("Phrase", "station")},
    {17, PHRASE_LATER("Phrase", "date")},
    {18, PHRASE_LATER("Phrase", "time")},
    {19, PHRASE_LATER("Phrase", "time")},
    {21, PHRASE_LATER("Phrase", "horizontal circle")},
    {22, PHRASE_LATER("Phrase", "vertical circle")},
    {25, PHRASE_LATER("Phrase", "difference of the horizontal circle")},
    {31, PHRASE_LATER("Phrase", "slope distance")},
    {32, PHRASE_LATER("Phrase", "horizontal distance")},
    {33, PHRASE_LATER("Phrase", "height difference")},
    {41, PHRASE_LATER("Phrase", "code")},
    {51, PHRASE_LATER("Phrase", "ppm and prism constant")},
    {52, PHRASE_LATER("Phrase", "number of measurements")},
    {53, PHRASE_LATER("Phrase", "signal strength")},
    {58, PHRASE_LATER("Phrase", "prism constant")},
    {59, PHRASE_LATER("Phrase", "ppm")},
    {81, PHRASE_LATER("Phrase", "easting")},
    {82, PHRASE_LATER("Phrase", "northing")},
    {83, PHRASE_LATER("Phrase", "height")},
    {84, PHRASE_LATER("Phrase", "station easting")},
    {85, PHRASE_LATER("Phrase", "station northing")},
    {86, PHRASE_LATER("Phrase", "station height")},
    {87, PHRASE_LATER("Phrase", "reflector height")},
}};

}  // namespace

bool looksLikeGsi(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  if (line.starts_with('*')) line.remove_prefix(1);
  return beginsWord(line);
}

std::variant<std::vector<GsiWord>, LineProblem> gsiWords(const TextLine& line) {
  std::vector<GsiWord> words;
  std::string_view rest = line.text;
  std::size_t column = 1;
  const auto skip = [&](std::size_t count) {
    count = std::min(count, rest.size());
    column += characterCount(rest.substr(0, count));
    rest.remove_prefix(count);
  };
  skip(std::min(rest.find_first_not_of(" \t"), rest.size()));
  const bool marked = rest.starts_with('*');
  if (marked) skip(1);
  while (!rest.empty() || (marked && words.empty())) {
    const std::string shown = quotation(rest.substr(0, std::min(rest.find_first_of(" \t"), rest.size())));
    if (!beginsWord(rest))
      return LineProblem{
          line.number, column,
          Phrase::of("%1 is no GSI word such as 21.102+17920860: transfer the file anew, or mend "
                     "or delete the line",
                     shown)};
    const std::size_t width = dataWidth(rest, marked);
    if (width == 0)
      return LineProblem{
          line.number, column,
          marked ? Phrase::of("%1 has neither 8 nor 16 characters of data, and a block that starts "
                              "with * has 16: transfer the file anew, or mend or delete the line",
                              shown)
                 : Phrase::of("%1 has neither 8 nor 16 characters of data: transfer the file anew, "
                              "or mend or delete the line",
                              shown)};
    if (words.size() == limits::mostColumns)
      return LineProblem{
          line.number, column,
          Phrase::of("has more than %1 words: transfer the file anew", limits::asCount(limits::mostColumns))};
    words.push_back(
        {(rest[0] - '0') * 10 + (rest[1] - '0'), rest[5], rest[6], rest.substr(dataAt, width), column});
    skip(dataAt + width);
    skip(std::min(rest.find_first_not_of(" \t"), rest.size()));
  }
  return words;
}

std::string gsiText(const GsiWord& word) {
  std::string_view data = word.data;
  while (!data.empty() && data.back() == ' ') data.remove_suffix(1);
  while (data.size() > 1 && (data.front() == '0' || data.front() == ' ')) data.remove_prefix(1);
  return data == " " ? std::string() : std::string(data);
}

std::variant<std::string, LineProblem> gsiAngle(const GsiWord& word, std::size_t line) {
  const auto refuse = [&](const std::string& why) {
    return LineProblem{line, word.column, gsiWordName(word.index) + " " + quotation(word.data) + " " + why};
  };
  std::uint64_t units = 0;
  const char* end = word.data.data() + word.data.size();
  const auto [stop, error] = std::from_chars(word.data.data(), end, units);
  if (error != std::errc() || stop != end)
    return refuse(Phrase::of("is not made of digits: transfer the file anew"));
  if (units >= mostUnits) return refuse(Phrase::of("is larger than a circle: transfer the file anew"));
  const std::string sign = word.sign == '-' ? "-" : "";
  switch (word.unit) {
    case '2':
      return sign + withDecimals(units, 100'000, 5) + "gon";
    case '3':
      return sign + withDecimals(units, 100'000, 5) + "°";
    case '4':
      return sign + sexagesimal(units);
    case '5':  // 10⁻⁴ mil, 6400 to a turn: 5625·10⁻⁹ degrees
      return sign + withDecimals(units * 5625, 1'000'000'000, 9) + "°";
    default:
      return refuse(
          Phrase::of("has no unit of an angle: position 6 of the word is “%1”, and 2 is gon, 3 decimal "
                     "degrees, 4 degrees minutes seconds, 5 mil",
                     std::string(1, word.unit)));
  }
}

std::optional<double> gsiMetres(const GsiWord& word) {
  constexpr double foot = 0.3048;
  std::uint64_t units = 0;
  const char* end = word.data.data() + word.data.size();
  const auto [stop, error] = std::from_chars(word.data.data(), end, units);
  if (error != std::errc() || stop != end || word.sign == '-') return std::nullopt;
  const auto length = static_cast<double>(units);
  switch (word.unit) {
    case '0':
      return length / 1e3;
    case '1':
      return length / 1e3 * foot;
    case '6':
      return length / 1e4;
    case '7':
      return length / 1e4 * foot;
    case '8':
      return length / 1e5;
    default:
      return std::nullopt;
  }
}

std::string gsiWordName(int index) {
  const auto* const known = std::find_if(wordNames.begin(), wordNames.end(),
                                         [index](const auto& name) { return name.first == index; });
  if (known != wordNames.end()) return Phrase::of(known->second);
  if (index == 88) return Phrase::of("instrument height");
  if (index >= 42 && index <= 49) return Phrase::of("information %1", index - 41);
  if (index >= 71 && index <= 79) return Phrase::of("remark %1", index - 70);
  return Phrase::of("word %1", index);
}

}  // namespace alidade
