#include "core/exchange/angle_parts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

constexpr std::string_view partMarks[] = {"°", "'", "\""};

/// One part of an angle as its digits, with at most one decimal point.
struct AnglePartText {
  std::string digits;
  bool isNegative = false;

  bool isWhole() const { return digits.find('.') == std::string::npos; }
  int whole() const { return std::stoi(digits); }
  bool isZero() const { return digits.find_first_not_of("0.") == std::string::npos; }
};

/// Shortens 41.0 to 41.
void dropNoughts(std::string& digits) {
  const std::size_t point = digits.find('.');
  if (point != std::string::npos && digits.find_first_not_of('0', point + 1) == std::string::npos)
    digits.resize(point);
}

/// The cell as a part of an angle; absent unless it is a number below a thousand.
std::optional<AnglePartText> partOf(std::string_view cell, std::string_view mark) {
  AnglePartText part;
  std::string text = plainSigns(cell);
  if (mark == "\"" && text.ends_with("''")) text.resize(text.size() - 2);
  if (text.ends_with(mark)) text = plainSigns(std::string_view(text).substr(0, text.size() - mark.size()));
  if (text.starts_with('-') || text.starts_with('+')) {
    part.isNegative = text[0] == '-';
    text = plainSigns(std::string_view(text).substr(1));
  }
  std::replace(text.begin(), text.end(), ',', '.');
  constexpr std::size_t mostWhole = 3, mostDigits = 15;
  const std::size_t point = std::min(text.find('.'), text.size());
  const bool isNumber = point > 0 && point <= mostWhole && text.size() <= mostDigits && text.back() != '.' &&
                        std::count(text.begin(), text.end(), '.') <= 1 &&
                        std::ranges::all_of(text, [](char c) { return isDigit(c) || c == '.'; });
  if (!isNumber) return std::nullopt;
  part.digits = std::move(text);
  return part;
}

/// Pads the part before the decimal point to two digits.
std::string twoDigits(std::string digits) {
  const std::size_t whole = std::min(digits.find('.'), digits.size());
  if (whole < 2) digits.insert(0, 2 - whole, '0');
  return digits;
}

/// Joins the parts of one angle.
class PartsJoiner {
 public:
  PartsJoiner(const std::array<std::string_view, 3>& cells, bool hasSeconds, bool isCentesimal)
      : m_cells(cells), m_count(hasSeconds ? 3 : 2), m_isCentesimal(isCentesimal) {}

  Result<FileAngle> join() {
    if (auto problem = takeParts()) return *std::move(problem);
    if (auto problem = takeSign()) return *std::move(problem);
    if (auto problem = carry()) return *std::move(problem);
    FileAngle angle = angleOfFile(m_isCentesimal ? gonText() : dmsText());
    angle.isCarried = m_isCarried;
    return angle;
  }

 private:
  std::string quoted() const {
    std::string text(m_cells[0]);
    for (std::size_t i = 1; i < m_count; ++i) text.append(" ").append(m_cells[i]);
    return quotation(text);
  }

  std::optional<Problem> takeParts() {
    for (std::size_t i = 0; i < m_count; ++i) {
      const auto part = partOf(m_cells[i], partMarks[i]);
      if (m_cells[i].empty())
        return Problem{
            Phrase::of("%1 lacks degrees, minutes or seconds: enter 0 for the missing part", quoted())};
      if (!part)
        return Problem{Phrase::of("%1 is not an angle: type an angle such as 341°52'24\"", quoted())};
      m_parts[i] = *part;
      if (i == 1 && m_count == 3 && m_cells[2].empty() && !part->isWhole())
        m_count = 2;  // minutes have decimals
      if (i + 1 < m_count) dropNoughts(m_parts[i].digits);
      if (i + 1 < m_count && !m_parts[i].isWhole())
        return Problem{Phrase::of(
            "%1 has decimals before its last part: only the last part may have decimals", quoted())};
    }
    return std::nullopt;
  }

  /// The sign belongs to the first part that is not 0; later parts may repeat it.
  std::optional<Problem> takeSign() {
    m_isNegative = m_parts[0].isNegative;
    bool isDecided = m_isNegative || !m_parts[0].isZero();
    for (std::size_t i = 1; i < m_count; ++i) {
      if (m_parts[i].isNegative && isDecided && !m_isNegative)
        return Problem{Phrase::of("%1 has a sign in the middle: put the sign before the degrees", quoted())};
      m_isNegative = m_isNegative || m_parts[i].isNegative;
      isDecided = isDecided || !m_parts[i].isZero();
    }
    return std::nullopt;
  }

  /// Carries a part of 60 (100 in gon) into the part before it; a larger part is a problem.
  std::optional<Problem> carry() {
    const double most = m_isCentesimal ? 100 : 60;
    for (std::size_t i = m_count - 1; i > 0; --i) {
      const double value = *parseNumber(m_parts[i].digits);
      if (value < most) continue;
      if (value > most)
        return Problem{i == 1 ? Phrase::of("%1 has %2 minutes: minutes go from 0 to %3", quoted(), m_cells[i],
                                           static_cast<int>(most) - 1)
                              : Phrase::of("%1 has %2 seconds: seconds stay below %3", quoted(), m_cells[i],
                                           static_cast<int>(most))};
      m_parts[i].digits.replace(0, std::min(m_parts[i].digits.find('.'), m_parts[i].digits.size()), "0");
      m_parts[i - 1].digits = std::to_string(m_parts[i - 1].whole() + 1);
      m_isCarried = true;
    }
    return std::nullopt;
  }

  std::string sign() const { return m_isNegative ? "-" : ""; }

  std::string dmsText() const {
    std::string text = sign() + m_parts[0].digits;
    for (std::size_t i = 1; i < m_count; ++i) text += " " + twoDigits(m_parts[i].digits);
    return text;
  }

  std::string gonText() const {
    std::string text = sign() + m_parts[0].digits + ".";
    for (std::size_t i = 1; i < m_count; ++i) {
      std::string digits = twoDigits(m_parts[i].digits);
      std::erase(digits, '.');
      text += digits;
    }
    return text + "gon";
  }

  const std::array<std::string_view, 3>& m_cells;
  std::size_t m_count;
  bool m_isCentesimal, m_isNegative = false, m_isCarried = false;
  std::array<AnglePartText, 3> m_parts;
};

/// The numbers of a text such as 107°12'60" or 107-12-60; empty if it contains anything else.
std::vector<std::string_view> numbersOf(std::string_view text) {
  constexpr std::string_view numerals = "0123456789.,", between = "'\" -:/\xC2\xB0";
  std::vector<std::string_view> numbers;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find_first_not_of(numerals), text.size());
    if (length > 0) numbers.push_back(text.substr(0, length));
    text.remove_prefix(length);
    const std::size_t gap = std::min(text.find_first_not_of(between), text.size());
    if (length == 0 && gap == 0) return {};
    text.remove_prefix(gap);
  }
  return numbers;
}

bool isSixty(std::string_view number) {
  const auto value = parseNumber(number);
  constexpr double turn = 60;
  return value && *value == turn;
}

/// The angle with minutes or seconds of 60 carried; absent if nothing is to be carried.
std::optional<FileAngle> carriedAngle(std::string_view text) {
  const std::string plain = plainSigns(text);
  std::string_view body = plain;
  const bool isNegative = body.starts_with('-');
  if (isNegative) body.remove_prefix(1);
  const std::vector<std::string_view> numbers = numbersOf(body);
  if (numbers.size() < 2 || numbers.size() > 3) return std::nullopt;
  if (std::none_of(numbers.begin() + 1, numbers.end(), isSixty)) return std::nullopt;
  const std::string degrees = (isNegative ? "-" : "") + std::string(numbers[0]);
  const auto joined =
      joinedAngle({degrees, numbers[1], numbers.size() == 3 ? numbers[2] : std::string_view()},
                  numbers.size() == 3, false);
  return joined ? std::optional(*joined) : std::nullopt;
}

}  // namespace

Result<FileAngle> joinedAngle(const std::array<std::string_view, 3>& parts, bool hasSeconds,
                              bool isCentesimal) {
  return PartsJoiner(parts, hasSeconds, isCentesimal).join();
}

FileAngle angleOfFile(std::string text) {
  const Result<Angle> angle = parseAngle(text);
  if (!angle) {
    if (auto carried = carriedAngle(text)) return *std::move(carried);
    return {.text = std::move(text)};
  }
  constexpr double turn = 360, rounding = 1e-12;
  if (std::abs(angle->degrees() - turn) > rounding) return {.text = std::move(text)};
  const bool isGon = plainSigns(text).ends_with("gon");
  return {.text = isGon ? "0gon" : "0°", .isFullCircle = true};
}

}  // namespace alidade
