#include "core/exchange/gsi_word.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "core/base/limits.h"
#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/utf8.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

constexpr std::size_t dataAt = 7, shortData = 8, longData = 16;

bool isGsiBlank(char c) {
  return c == ' ' || c == '\t';
}

std::size_t blanksAt(std::string_view text) {
  return std::min(text.find_first_not_of(" \t"), text.size());
}

bool isInformation(char c) {
  return isDigit(c) || c == '.';
}

bool beginsWord(std::string_view text) {
  return text.size() >= dataAt && isDigit(text[0]) && isDigit(text[1]) &&
         std::all_of(text.begin() + 2, text.begin() + 6, isInformation) && (text[6] == '+' || text[6] == '-');
}

/// Does the text look like a damaged word: two digits, a third or a point, and a sign in characters 4 to 10?
bool isNearlyWord(std::string_view text) {
  constexpr std::size_t farthestSign = 9;
  const std::size_t sign = text.find_first_of("+-");
  return sign > 2 && sign <= farthestSign && isDigit(text[0]) && isDigit(text[1]) && isInformation(text[2]);
}

/// Can a word end before this text? After blanks the text must be empty or begin a word, perhaps after a *.
bool isBeforeWord(std::string_view text) {
  text.remove_prefix(blanksAt(text));
  if (text.starts_with('*')) text.remove_prefix(1);
  return text.empty() || beginsWord(text);
}

/// Is the data a number with a decimal sign, which makes the data one character longer?
bool hasWrittenPoint(std::string_view data) {
  return data.find_first_of(".,") != std::string_view::npos &&
         std::all_of(data.begin(), data.end(),
                     [](char c) { return isDigit(c) || c == '.' || c == ',' || c == ' '; });
}

/// The width of data as different programs count it.
struct Widths {
  std::size_t characters = 0, bytes = 0, cells = 0;

  void add(const Utf8Character& character) {
    constexpr char32_t firstOfEastAsia = 0x2E80;
    ++characters;
    bytes += character.length;
    cells += character.code >= firstOfEastAsia && character.code != 0xFFFD ? 2 : 1;
  }
  bool areOne(std::size_t width) const { return characters == width || bytes == width || cells == width; }
};

bool isWidth(const Widths& widths, std::string_view data, bool isMarked) {
  const std::size_t more = hasWrittenPoint(data) ? 1 : 0;
  const auto is = [&](std::size_t width) {
    return widths.areOne(width) || (more && widths.areOne(width + 1));
  };
  return is(longData) || (!isMarked && is(shortData));
}

/// Is this a check sum at the end of a line, such as *5A?
bool isCheckSum(std::string_view text) {
  constexpr std::size_t shortest = 3, longest = 5;
  while (!text.empty() && isGsiBlank(text.back())) text.remove_suffix(1);
  return text.size() >= shortest && text.size() <= longest && text[0] == '*' &&
         text.find_first_not_of("0123456789ABCDEFabcdef", 1) == std::string_view::npos;
}

/// Is this a comma or semicolon, which some programs write between words and after the last word?
bool isSeparator(std::string_view text) {
  if (text.empty() || (text[0] != ',' && text[0] != ';')) return false;
  text.remove_prefix(1);
  text.remove_prefix(blanksAt(text));
  return text.empty() || beginsWord(text);
}

/// Can a word of the right width end before `text[at]`?
bool mayEndWord(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  if (rest.empty() || isGsiBlank(rest[0])) return true;
  const bool isFull = at > 0 && !isGsiBlank(text[at - 1]);
  return isFull && (beginsWord(rest) || isSeparator(rest) || isCheckSum(rest));
}

/// The end of a word's data, in bytes.
struct DataEnd {
  std::size_t at = 0;
  bool isWhole = false;
};

/// The position of the first blank before a word or the end.
std::size_t endBeforeWord(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool isFirstBlank = isGsiBlank(text[at]) && (at == 0 || !isGsiBlank(text[at - 1]));
    if (isFirstBlank && isBeforeWord(text.substr(at))) return at;
  }
  return text.size();
}

/// Does the data have the format's width in ASCII characters without blanks, as almost all words do?
bool isPlainWord(std::string_view text, std::size_t width) {
  if (text.size() < width || (text.size() > width && text[width] != ' ')) return false;
  return std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(width),
                     [](char c) { return c > ' ' && c <= '~'; });
}

/// The end of the data: a width of the format, preferably one before another word or the end of the line. The
/// data never reaches into another word.
DataEnd dataEnd(std::string_view text, bool isMarked) {
  constexpr std::size_t widest = longData + 1;
  const std::size_t width = isMarked ? longData : shortData;
  if (isPlainWord(text, width) && isBeforeWord(text.substr(width))) return {width, true};
  Widths widths;
  std::optional<std::size_t> whole;
  for (std::size_t at = 0; widths.characters <= widest; at = widths.bytes) {
    const bool isBlank = at < text.size() && isGsiBlank(text[at]);
    if (isWidth(widths, text.substr(0, at), isMarked) && mayEndWord(text, at)) {
      if (!isBlank || isBeforeWord(text.substr(at))) return {at, true};
      if (!whole) whole = at;
    }
    if (at == text.size() || (isBlank && beginsWord(text.substr(at + 1)))) break;
    widths.add(firstCharacter(text.substr(at)));
  }
  if (whole) return {*whole, true};
  return {endBeforeWord(text), false};
}

/// The index: two digits, or three if the third belongs to it, as in 331 but not in 110001 and 21.102.
int indexOfWord(std::string_view text) {
  constexpr int staff = 33;
  const auto digit = [&text](std::size_t at) { return text[at] - '0'; };
  const int index = digit(0) * 10 + digit(1);
  if (index == 11 || index == 41 || !isDigit(text[2])) return index;
  return text[2] != '0' || index == staff ? index * 10 + digit(2) : index;
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
  line.remove_prefix(blanksAt(line));
  if (line.starts_with('*')) line.remove_prefix(1);
  return beginsWord(line);
}

GsiBlocks::GsiBlocks(const TextLine& line) : m_rest(line.text) {
  skipBlanks();
}

void GsiBlocks::skip(std::size_t count) {
  count = std::min(count, m_rest.size());
  m_column += characterCount(m_rest.substr(0, count));
  m_rest.remove_prefix(count);
}

void GsiBlocks::skipBlanks() {
  skip(blanksAt(m_rest));
}

/// Skips the * of a wide block if a word follows it; false if nothing was skipped.
bool GsiBlocks::takeStar() {
  if (!m_rest.starts_with('*')) return false;
  const std::size_t behind = 1 + blanksAt(m_rest.substr(1));
  if (!beginsWord(m_rest.substr(behind))) return false;
  skip(behind);
  return m_isMarked = true;
}

GsiWord GsiBlocks::takeWord() {
  const DataEnd end = dataEnd(m_rest.substr(dataAt), m_isMarked);
  const GsiWord word{.index = indexOfWord(m_rest),
                     .unit = m_rest[5],
                     .sign = m_rest[6],
                     .data = m_rest.substr(dataAt, end.at),
                     .column = m_column,
                     .compensator = m_rest[3],
                     .input = m_rest[4],
                     .isWhole = end.isWhole,
                     .isNumbered = std::all_of(m_rest.begin() + 2, m_rest.begin() + 6, isDigit)};
  skip(dataAt + end.at);
  skip(isSeparator(m_rest) ? 1 : 0);
  skipBlanks();
  return word;
}

GsiWord GsiBlocks::takeTorn() {
  const std::size_t end = endBeforeWord(m_rest);
  std::string_view text = m_rest.substr(0, end);
  GsiWord word{.data = text, .column = m_column, .isWhole = false};
  if (text.starts_with('*')) text.remove_prefix(1);
  if (isNearlyWord(text)) word.index = (text[0] - '0') * 10 + (text[1] - '0');
  skip(end);
  skipBlanks();
  return word;
}

bool GsiBlocks::beginsBlock(const GsiBlock& block) const {
  constexpr int point = 11, code = 41;
  const auto has = [&block](auto what) { return std::ranges::any_of(block.words, what); };
  const auto isPoint = [](const GsiWord& word) { return word.index == point; };
  const auto isCodeBlock = [](const GsiWord& word) { return word.index == code && word.isNumbered; };
  const int index = indexOfWord(m_rest);
  if (index == point) return has(isPoint) || has(isCodeBlock);
  const bool isNumbered = std::all_of(m_rest.begin() + 2, m_rest.begin() + 6, isDigit);
  return index == code && isNumbered && !block.words.empty();
}

std::optional<GsiBlock> GsiBlocks::next() {
  GsiBlock block;
  while (!m_rest.empty() && block.words.size() + block.torn.size() < limits::mostColumns) {
    if (!m_hasStar && takeStar()) {
      m_hasStar = true;
      if (!block.words.empty()) return block;
    } else if (!beginsWord(m_rest)) {
      block.torn.push_back(takeTorn());
    } else if (!m_hasStar && beginsBlock(block)) {
      return block;
    } else {
      m_hasStar = false;
      block.words.push_back(takeWord());
    }
  }
  if (block.words.empty() && block.torn.empty()) return std::nullopt;
  return block;
}

namespace {

std::string whyTorn(const GsiWord& word, bool isMarked) {
  if (!isMarked)
    return Phrase::of(
        "%1 has neither 8 nor 16 characters of data: transfer the file again, or correct or delete the line",
        quotation(word.data));
  return Phrase::of(
      "%1 has neither 8 nor 16 characters of data, and a block that starts with * has 16: transfer the file "
      "again, or correct or delete the line",
      quotation(word.data));
}

std::string whyNoWord(std::string_view text) {
  const std::string_view first = text.substr(0, text.find_first_of(" \t"));
  return Phrase::of(
      "%1 is no GSI word such as 21.102+17920860: transfer the file again, or correct or delete the line",
      quotation(first));
}

/// The problem of the first damaged word of a block.
std::optional<LineProblem> firstTorn(const GsiBlock& block, const TextLine& line) {
  std::optional<LineProblem> first;
  const auto take = [&](const GsiWord& word, const std::string& what) {
    if (!first || word.column < first->column) first = LineProblem{line.number, word.column, what};
  };
  const bool isMarked = line.text.substr(blanksAt(line.text)).starts_with('*');
  for (const GsiWord& word : block.torn) take(word, whyNoWord(word.data));
  for (const GsiWord& word : block.words)
    if (!word.isWhole) take(word, whyTorn(word, isMarked));
  return first;
}

}  // namespace

std::variant<std::vector<GsiWord>, LineProblem> gsiWords(const TextLine& line) {
  std::vector<GsiWord> words;
  GsiBlocks blocks(line);
  while (const auto block = blocks.next()) {
    if (auto problem = firstTorn(*block, line)) return *std::move(problem);
    words.insert(words.end(), block->words.begin(), block->words.end());
    if (words.size() >= limits::mostColumns)
      return LineProblem{
          line.number, words.back().column,
          Phrase::of("has %1 words or more: transfer the file again", limits::asCount(limits::mostColumns))};
  }
  return words;
}

std::string gsiText(const GsiWord& word) {
  std::string_view data = word.data;
  while (!data.empty() && data.back() == ' ') data.remove_suffix(1);
  while (data.size() > 1 && (data.front() == '0' || data.front() == ' ')) data.remove_prefix(1);
  return data == " " ? std::string() : std::string(data);
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
