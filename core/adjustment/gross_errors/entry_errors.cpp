#include "core/adjustment/gross_errors/entry_errors.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "core/base/angle_text.h"
#include "core/base/typed_text.h"

namespace alidade {

namespace {

struct KnownEntryError {
  EntryError error;
  double share;
};

/// The shares are rough: they only have to keep every kind possible.
constexpr std::array<KnownEntryError, 9> entryErrors = {{
    {EntryError::DigitsSwapped, 0.20},
    {EntryError::OneDigitWrong, 0.25},
    {EntryError::DegreeOff, 0.08},
    {EntryError::TenMinutesOff, 0.08},
    {EntryError::MinuteOff, 0.08},
    {EntryError::TenSecondsOff, 0.08},
    {EntryError::CirclesSwapped, 0.06},
    {EntryError::WrongFace, 0.08},
    {EntryError::NeighbouringRow, 0.09},
}};

/// The places of the digits of degrees, minutes and seconds in a text.
struct Parts {
  struct Span {
    std::size_t at = 0, length = 0;
  };
  Span degrees, minutes, seconds;
};

std::optional<Parts> partsOf(std::string_view text) {
  std::vector<Parts::Span> runs;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && isDigit(text[end])) ++end;
    if (end > i) runs.push_back({i, end - i});
    i = std::max(end, i + 1);
  }
  if (runs.empty()) return std::nullopt;
  const Parts::Span first = runs.front();
  if (first.length >= 5 && first.length <= 7)  // without separators: DDDMMSS
    return Parts{
        {first.at, first.length - 4}, {first.at + first.length - 4, 2}, {first.at + first.length - 2, 2}};
  if (runs.size() < 3 || first.length > 3 || runs[1].length > 2 || runs[2].length > 2) return std::nullopt;
  return Parts{runs[0], runs[1], runs[2]};
}

int numberAt(std::string_view text, Parts::Span span) {
  int number = 0;
  for (const char c : text.substr(span.at, span.length)) number = 10 * number + (c - '0');
  return number;
}

std::string padded(int number, std::size_t width) {
  const std::string digits = std::to_string(number);
  return std::string(width > digits.size() ? width - digits.size() : 0, '0') + digits;
}

/// The text with whole seconds added; all other characters stay as typed.
std::string moved(std::string_view typed, const Parts& parts, int seconds) {
  constexpr int turn = 360 * 3600;
  const int before = 3600 * numberAt(typed, parts.degrees) + 60 * numberAt(typed, parts.minutes) +
                     numberAt(typed, parts.seconds);
  const int after = ((before + seconds) % turn + turn) % turn;
  std::string text(typed);
  const auto put = [&text](Parts::Span span, int number) {
    text.replace(span.at, span.length, padded(number, span.length));
  };
  put(parts.seconds, after % 60);  // from the end, so that earlier places stay valid
  put(parts.minutes, after / 60 % 60);
  // Leading zeros of the degrees are kept only if they were typed.
  if (typed[parts.degrees.at] == '0')
    put(parts.degrees, after / 3600);
  else
    text.replace(parts.degrees.at, parts.degrees.length, std::to_string(after / 3600));
  return text;
}

/// Does the text begin with a zero before another digit? A correction never introduces such a zero.
bool startsWithZero(std::string_view text) {
  return text.size() > 1 && text[0] == '0' && isDigit(text[1]);
}

class Collector {
 public:
  explicit Collector(std::string_view typed) : m_typed(typed) {}

  void add(EntryError error, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      if (text == m_typed || (startsWithZero(text) && !startsWithZero(m_typed))) continue;
      const double prior = entryErrorShare(error) / static_cast<double>(texts.size());
      const auto found = std::ranges::find(m_intended, text, &IntendedText::text);
      if (found == m_intended.end()) {
        m_intended.push_back({error, text, prior});
        continue;
      }
      if (prior > found->prior) found->error = error;
      found->prior += prior;
    }
  }

  std::vector<IntendedText> take() { return std::move(m_intended); }

 private:
  std::string_view m_typed;
  std::vector<IntendedText> m_intended;
};

std::vector<std::string> withDigitsSwapped(std::string_view typed) {
  std::vector<std::string> texts;
  std::optional<std::size_t> before;
  for (std::size_t i = 0; i < typed.size(); ++i) {
    if (!isDigit(typed[i])) continue;
    if (before && typed[*before] != typed[i]) {
      texts.emplace_back(typed);
      std::swap(texts.back()[*before], texts.back()[i]);
    }
    before = i;
  }
  return texts;
}

std::vector<std::string> withOneDigitChanged(std::string_view typed) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < typed.size(); ++i) {
    if (!isDigit(typed[i])) continue;
    for (char digit = '0'; digit <= '9'; ++digit) {
      if (digit == typed[i]) continue;
      texts.emplace_back(typed);
      texts.back()[i] = digit;
    }
  }
  return texts;
}

}  // namespace

double entryErrorShare(EntryError error) {
  return std::ranges::find(entryErrors, error, &KnownEntryError::error)->share;
}

std::vector<IntendedText> intendedTexts(std::string_view typed) {
  Collector collector(typed);
  if (const auto parts = partsOf(typed); parts && parseAngle(typed)) {
    const auto off = [&](EntryError error, int seconds) {
      collector.add(error, {moved(typed, *parts, seconds), moved(typed, *parts, -seconds)});
    };
    off(EntryError::DegreeOff, 3600);
    off(EntryError::TenMinutesOff, 600);
    off(EntryError::MinuteOff, 60);
    off(EntryError::TenSecondsOff, 10);
  }
  collector.add(EntryError::DigitsSwapped, withDigitsSwapped(typed));
  collector.add(EntryError::OneDigitWrong, withOneDigitChanged(typed));
  return collector.take();
}

}  // namespace alidade
