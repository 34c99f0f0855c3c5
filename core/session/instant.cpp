#include "core/session/time_text.h"

#include <chrono>
#include <cmath>

namespace alidade {

namespace {

/// Reads a text from its beginning.
class InstantReader {
 public:
  explicit InstantReader(std::string_view text) : m_rest(text) {}

  bool isAtEnd() const { return m_rest.empty(); }

  bool take(char sign) {
    if (m_rest.empty() || m_rest.front() != sign) return false;
    m_rest.remove_prefix(1);
    return true;
  }

  /// A number of exactly `count` digits; −1 if there are fewer.
  int digits(std::size_t count) {
    if (m_rest.size() < count) return -1;
    int number = 0;
    for (const char digit : m_rest.substr(0, count)) {
      if (digit < '0' || digit > '9') return -1;
      number = 10 * number + (digit - '0');
    }
    m_rest.remove_prefix(count);
    return number;
  }

  /// The decimals of the seconds, after the point.
  double fraction() {
    double sum = 0, place = 1;
    for (; !m_rest.empty() && m_rest.front() >= '0' && m_rest.front() <= '9'; m_rest.remove_prefix(1))
      sum += (m_rest.front() - '0') * (place /= 10);
    return sum;
  }

  /// Minutes east of UTC, 0 if no zone is stated; absent if the zone cannot be read.
  std::optional<int> zone() {
    if (m_rest.empty() || take('Z')) return 0;
    const bool isEast = take('+');
    if (!isEast && !take('-')) return std::nullopt;
    const int hours = digits(2);
    const bool hasColon = take(':');
    const int minutes = isAtEnd() && !hasColon ? 0 : digits(2);
    if (hours < 0 || hours > 14 || minutes < 0 || minutes > 59) return std::nullopt;
    return (isEast ? 1 : -1) * (60 * hours + minutes);
  }

 private:
  std::string_view m_rest;
};

}  // namespace

std::optional<double> minutesOf(std::string_view text) {
  InstantReader reader(text);
  const int year = reader.digits(4);
  if (!reader.take('-')) return std::nullopt;
  const int month = reader.digits(2);
  if (!reader.take('-')) return std::nullopt;
  const int day = reader.digits(2);
  if (!reader.take('T') && !reader.take(' ')) return std::nullopt;
  const int hour = reader.digits(2);
  if (!reader.take(':')) return std::nullopt;
  const int minute = reader.digits(2);
  double second = 0;
  if (reader.take(':')) {
    second = reader.digits(2);
    if (second < 0 || second > 60) return std::nullopt;
    if (reader.take('.') || reader.take(',')) second += reader.fraction();
  }
  const std::optional<int> zone = reader.zone();
  if (!zone || !reader.isAtEnd() || year < 0 || month < 1 || day < 1 || hour < 0 || hour > 24 || minute < 0 ||
      minute > 59)
    return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(unsigned(month)),
                                         std::chrono::day(unsigned(day))};
  if (!date.ok()) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return static_cast<double>(days) * 1440.0 + 60.0 * hour + minute - *zone + second / 60;
}

}  // namespace alidade
