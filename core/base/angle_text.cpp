#include "core/base/angle_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

constexpr std::string_view degreeSign = "°";

/// Degrees, minutes and seconds as typed: one to three unsigned decimal numbers; missing numbers are zero.
using Parts = std::vector<std::string>;

std::string trimmed(std::string_view text) {
  return plainSigns(text);
}

bool isWhole(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), isDigit);
}

/// Does the text consist of digits, with at most one decimal sign between them?
bool isDecimal(std::string_view text) {
  const auto sign = text.find_first_of(".,");
  if (sign == std::string_view::npos) return isWhole(text);
  return isWhole(text.substr(0, sign)) && isWhole(text.substr(sign + 1));
}

bool endsWithLetters(std::string_view text, std::string_view lowercase) {
  if (text.size() < lowercase.size()) return false;
  const std::string_view end = text.substr(text.size() - lowercase.size());
  return std::equal(end.begin(), end.end(), lowercase.begin(),
                    [](char typed, char wanted) { return (typed | 0x20) == wanted; });
}

Parts split(std::string_view text, char separator) {
  Parts parts;
  while (true) {
    const auto at = text.find(separator);
    parts.push_back(trimmed(text.substr(0, at)));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

/// Replaces Chinese units by signs: 107度12分23秒 becomes 107°12'23".
std::string withMarks(std::string text) {
  for (const auto& [word, sign] : {std::pair("度", degreeSign), std::pair("分", std::string_view("'")),
                                   std::pair("秒", std::string_view("\""))})
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + sign.size()))
      text.replace(at, std::string_view(word).size(), sign);
  return text;
}

/// Parses one typed angle. Messages quote `m_typed`; `m_body` is the text after the sign.
class AngleReader {
 public:
  explicit AngleReader(std::string_view typed) : m_typed(typed), m_body(withMarks(plainSigns(typed))) {
    if (!m_body.empty() && (m_body[0] == '-' || m_body[0] == '+')) {
      m_negative = m_body[0] == '-';
      m_body = trimmed(std::string_view(m_body).substr(1));
    }
  }

  Result<Angle> read() const {
    if (plainSigns(m_typed).empty())
      return Problem{Phrase::of("is empty: type an angle such as 341°52'24\"")};
    if (endsWithLetters(m_body, "gon")) return readUnit(3, &Angle::fromGon);
    if (endsWithLetters(m_body, "deg")) return readUnit(3, &Angle::fromDegrees);
    if (endsWithLetters(m_body, "g")) return readUnit(1, &Angle::fromGon);
    if (m_body.find(degreeSign) != std::string::npos) return readSigned();
    if (m_body.find_first_of("'\"") != std::string::npos) {
      if (hasForeignDigits(m_typed)) return notAnAngle();
      return Problem{Phrase::of("%1 has no degrees: type them too, such as 0°52'24\"", quoted())};
    }
    if (isDecimal(m_body)) return readBare();
    return readSeparated();
  }

 private:
  std::string quoted() const { return quotation(m_typed); }
  Problem notAnAngle() const {
    if (hasForeignDigits(m_typed))
      return {Phrase::of("%1 has digits of another script: type the digits 0 to 9", quoted())};
    return {Phrase::of("%1 is not an angle: type an angle such as 341°52'24\"", quoted())};
  }
  Problem tooLarge() const {
    return {Phrase::of("%1 is too large for an angle: check the digits", quoted())};
  }

  Result<Angle> readUnit(std::size_t unitLength, Angle (*make)(double)) const {
    const std::string number = trimmed(std::string_view(m_body).substr(0, m_body.size() - unitLength));
    if (!isDecimal(number)) return notAnAngle();
    const Result<double> value = parseNumber(number);
    if (!value) return tooLarge();
    return make(m_negative ? -*value : *value);
  }

  /// Reads an angle such as 341°52'24". Each mark follows its number; the last mark may be missing.
  Result<Angle> readSigned() const {
    std::string_view rest = m_body;
    Parts parts;
    for (const std::string_view mark : {degreeSign, std::string_view("'"), std::string_view("\"")}) {
      if (rest.empty()) break;
      const auto end = markAt(rest, mark);
      parts.push_back(trimmed(rest.substr(0, end.first)));
      rest = end.second >= rest.size() ? std::string_view() : rest.substr(end.second);
      rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    }
    if (!rest.empty()) return notAnAngle();
    return fromParts(parts);
  }

  /// The start and end of `mark` in `rest`; both are the end of `rest` if the mark is missing. Two primes
  /// also mark seconds.
  static std::pair<std::size_t, std::size_t> markAt(std::string_view rest, std::string_view mark) {
    const auto at = rest.find(mark);
    if (mark == "\"" && at == std::string_view::npos) {
      const auto primes = rest.find("''");
      if (primes != std::string_view::npos) return {primes, primes + 2};
    }
    if (at == std::string_view::npos) return {rest.size(), rest.size()};
    return {at, at + mark.size()};
  }

  /// Reads a number without any mark: whole degrees or consecutive digits. Refuses ambiguous numbers.
  Result<Angle> readBare() const {
    const auto sign = m_body.find_first_of(".,");
    const std::string digits = m_body.substr(0, sign);
    const bool runTogether = digits.size() >= 5 && digits.size() <= 7;
    if (runTogether) {
      const std::size_t degrees = digits.size() - 4;
      return fromParts({m_body.substr(0, degrees), m_body.substr(degrees, 2), m_body.substr(degrees + 2)});
    }
    if (sign != std::string::npos) return Problem{ambiguousDecimal(digits, m_body.substr(sign + 1))};
    if (digits.size() <= 3) return fromParts({digits});
    if (digits.size() == 4) {
      const std::string degrees = minus() + digits.substr(0, 2), minutes = digits.substr(2);
      return Problem{Phrase::of("%1 is ambiguous: type %2 %3 00 or %2°%3'", quoted(), degrees, minutes)};
    }
    return Problem{Phrase::of(
        "%1 has too many digits: type degrees, minutes and seconds as DDDMMSS or with blanks between them",
        quoted())};
  }

  std::string minus() const { return m_negative ? "-" : ""; }

  /// The problem of a bare decimal. If both meanings are angles, it names both: 341.5224° or 341 52 24.
  std::string ambiguousDecimal(const std::string& degrees, std::string decimals) const {
    if (degrees.size() > 3 || decimals.size() > 12) {
      return Phrase::of(
          "%1 may mean decimal degrees or degrees, minutes and seconds: put a degree sign behind decimal "
          "degrees, or blanks between degrees, minutes and seconds",
          quoted());
    }
    const std::string asDegrees = minus() + degrees + "." + decimals + "°";
    decimals.resize(std::max<std::size_t>(decimals.size(), 4), '0');
    std::string seconds = decimals.substr(2, 2);
    if (decimals.size() > 4) seconds += "." + decimals.substr(4);
    const std::string asParts = minus() + degrees + " " + decimals.substr(0, 2) + " " + seconds;
    const bool bothAngles = decimals[0] < '6' && decimals[2] < '6';
    if (bothAngles)
      return Phrase::of("%1 may mean decimal degrees or degrees, minutes and seconds: type %2 or %3",
                        quoted(), asDegrees, asParts);
    return Phrase::of(
        "%1 may mean decimal degrees or degrees, minutes and seconds: type %2 or put blanks between degrees, "
        "minutes and seconds",
        quoted(), asDegrees);
  }

  /// Reads parts that are separated by one kind of separator.
  Result<Angle> readSeparated() const {
    std::string separators;
    for (const char c : std::string_view("-:/")) {
      if (m_body.find(c) != std::string::npos) separators += c;
    }
    if (separators.size() > 1)
      return Problem{Phrase::of("%1 mixes separators: use one kind, such as 341 52 24", quoted())};
    if (separators.size() == 1) return fromParts(split(m_body, separators[0]));
    if (m_body.find(' ') != std::string::npos) {
      Parts parts = split(m_body, ' ');
      std::erase(parts, std::string());
      if (parts.size() == 2 && isWhole(parts[0]) && isWhole(parts[1]))
        return Problem{
            Phrase::of("%1 is ambiguous: type %2 %3 00 or %2°%3'", quoted(), minus() + parts[0], parts[1])};
      return fromParts(parts);
    }
    for (const char c : std::string_view(".,")) {
      if (std::count(m_body.begin(), m_body.end(), c) == 2) return fromParts(split(m_body, c));
    }
    return notAnAngle();
  }

  Result<Angle> fromParts(const Parts& parts) const {
    if (parts.size() > 3)
      return Problem{Phrase::of("%1 has more than three parts: type degrees, minutes and seconds", quoted())};
    double values[3] = {0, 0, 0};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!isDecimal(parts[i])) return notAnAngle();
      if (i + 1 < parts.size() && !isWhole(parts[i])) {
        return Problem{Phrase::of(
            "%1 has decimals before its last part: only the last part may have decimals", quoted())};
      }
      const Result<double> value = parseNumber(parts[i]);
      if (!value) return tooLarge();
      values[i] = *value;
    }
    if (values[1] >= 60)
      return Problem{Phrase::of("%1 has %2 minutes: minutes go from 0 to 59", quoted(), parts[1])};
    if (values[2] >= 60)
      return Problem{Phrase::of("%1 has %2 seconds: seconds stay below 60", quoted(), parts[2])};
    const double degrees = values[0] + values[1] / 60 + values[2] / 3600;
    return Angle::fromDegrees(m_negative ? -degrees : degrees);
  }

  std::string_view m_typed;
  std::string m_body;
  bool m_negative = false;
};

/// Removes the leading digits and returns their value; absent if there are none or more than `most`.
std::optional<int> takeDigits(std::string_view& text, std::size_t most) {
  const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
  if (count == 0 || count > most) return std::nullopt;
  int number = 0;
  for (const char digit : text.substr(0, count)) number = 10 * number + (digit - '0');
  text.remove_prefix(count);
  return number;
}

bool takeMark(std::string_view& text, std::string_view mark) {
  if (!text.starts_with(mark)) return false;
  text.remove_prefix(mark.size());
  return true;
}

/// Reads the most frequent notation, 341°52'24.5", quickly; absent for other texts.
std::optional<Angle> plainlyTyped(std::string_view text) {
  const auto degrees = takeDigits(text, 3);
  if (!degrees || !takeMark(text, degreeSign)) return std::nullopt;
  const auto minutes = takeDigits(text, 2);
  if (!minutes || *minutes >= 60 || !takeMark(text, "'") || text.empty() || !isDigit(text.front()))
    return std::nullopt;
  double seconds = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), seconds, std::chars_format::fixed);
  if (error != std::errc() || seconds >= 60 || !isDigit(end[-1])) return std::nullopt;
  if (std::string_view(end, text.data() + text.size()) != "\"") return std::nullopt;
  return Angle::fromDegrees(*degrees + static_cast<double>(*minutes) / 60 + seconds / 3600);
}

std::string padded(long long number, std::size_t width) {
  const std::string digits = std::to_string(number);
  return std::string(width > digits.size() ? width - digits.size() : 0, '0') + digits;
}

struct BareNumber {
  std::size_t digits = 0;  ///< digits before the decimal sign; 0: not a bare number
  bool hasDecimals = false;
};

BareNumber bareNumber(const std::string& typed) {
  const std::string plain = plainSigns(typed);
  std::string_view body = plain;
  if (!body.empty() && (body.front() == '-' || body.front() == '+')) body.remove_prefix(1);
  const auto isDigits = [](std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, isDigit);
  };
  const std::size_t sign = body.find_first_of(".,");
  const bool hasDecimals = sign != std::string_view::npos;
  if (!isDigits(body.substr(0, sign)) || (hasDecimals && !isDigits(body.substr(sign + 1)))) return {};
  return {hasDecimals ? sign : body.size(), hasDecimals};
}

/// Returns the angle in degrees or gon.
double valueIn(CircleUnit unit, Angle angle) {
  return unit == CircleUnit::Gon ? angle.degrees() / 0.9 : angle.degrees();
}

}  // namespace

Result<Angle> parseAngle(std::string_view text) {
  if (const auto angle = plainlyTyped(text)) return *angle;
  return AngleReader(text).read();
}

std::string formatDms(Angle angle, int decimals, AngleSigns signs) {
  constexpr double mostUnits = 9e18;
  long long perSecond = 1;
  for (int i = 0; i < std::clamp(decimals, 0, 9); ++i) perSecond *= 10;
  const double exactUnits = std::abs(angle.arcseconds()) * static_cast<double>(perSecond);
  if (!(exactUnits < mostUnits)) return shortestText(angle.degrees()) + "°";

  const long long units = std::llround(exactUnits);
  const long long seconds = units / perSecond;
  const bool typewriter = signs == AngleSigns::Typewriter;
  std::string text;
  if (angle.radians() < 0 && units > 0) text = typewriter ? "-" : "−";
  text += std::to_string(seconds / 3600) + "°" + padded(seconds / 60 % 60, 2) + (typewriter ? "'" : "′") +
          padded(seconds % 60, 2);
  if (perSecond > 1)
    text += "." + padded(units % perSecond, static_cast<std::size_t>(std::clamp(decimals, 0, 9)));
  return text + (typewriter ? "\"" : "″");
}

bool areEqualAsTyped(Angle a, Angle b) {
  constexpr double rounding = 1e-6;  // arcsec
  return std::abs(wrapped(a - b).arcseconds()) < rounding;
}

std::string completedAngle(const std::string& typed, CircleUnit unit) {
  const BareNumber number = bareNumber(typed);
  if (number.digits == 0) return typed;
  constexpr std::size_t mostDigits = 3;
  if (unit == CircleUnit::Gon) return typed + "gon";
  if (unit == CircleUnit::Degrees && number.hasDecimals && number.digits <= mostDigits) return typed + "°";
  return typed;
}

int decimalsOf(Angle angle, CircleUnit unit) {
  constexpr int most = 3, usual = 1;
  const double value = unit == CircleUnit::Dms ? angle.arcseconds() : valueIn(unit, angle) * 1e4;
  for (int decimals = 0; decimals <= most; ++decimals) {
    const double scaled = value * std::pow(10, decimals);
    if (std::abs(scaled - std::round(scaled)) < 1e-3 * std::pow(10, decimals - most)) return decimals;
  }
  return usual;
}

std::string formatAngle(Angle angle, CircleUnit unit, int decimals) {
  if (unit == CircleUnit::Dms) return formatDms(angle, decimals);
  return displayText(valueIn(unit, angle), decimals + 4) + (unit == CircleUnit::Gon ? " gon" : "°");
}

std::string formatCircleReading(Angle reading, CircleUnit unit, int decimals) {
  constexpr Angle half = Angle::fromDegrees(180);
  const std::string text = formatAngle(wrapped(reading, half), unit, decimals);
  return text == formatAngle(half + half, unit, decimals) ? formatAngle(Angle(), unit, decimals) : text;
}

}  // namespace alidade
