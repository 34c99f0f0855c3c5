#include "core/series/history/history_date.h"

#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

constexpr int earliestYear = 1500, latestYear = 2200;  // since the first theodolites, with a margin

constexpr std::chrono::sys_days origin =
    std::chrono::year_month_day(std::chrono::year(2000), std::chrono::January, std::chrono::day(1));

double dayOf(std::chrono::sys_days date) {
  return static_cast<double>((date - origin).count());
}

std::optional<double> dayOf(int year, int month, int day) {
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (year < earliestYear || year > latestYear || !date.ok()) return std::nullopt;
  return dayOf(date);
}

/// Groups of digits, all separated by the same sign.
struct Parts {
  std::vector<int> numbers;
  std::vector<std::size_t> lengths;
  char sign = 0;
};

std::optional<Parts> partsOf(std::string_view text) {
  Parts parts;
  std::size_t digits = 0;
  int number = 0;
  const auto close = [&] {
    parts.numbers.push_back(number);
    parts.lengths.push_back(digits);
    number = 0;
    digits = 0;
  };
  for (const char c : text) {
    if (isDigit(c)) {
      if (++digits > 8) return std::nullopt;
      number = 10 * number + (c - '0');
    } else if (digits > 0 && (parts.sign == 0 || parts.sign == c)) {
      parts.sign = c;
      close();
    } else {
      return std::nullopt;
    }
  }
  if (digits == 0) return std::nullopt;
  close();
  return parts;
}

Problem noDate(std::string_view text) {
  return Problem{Phrase::of("%1 is no date: write year-month-day, year-month, a year or a decimal year",
                            quotation(text))};
}

bool parts(const std::string& sign, char c) {
  return sign.find(c) != std::string::npos;
}

std::optional<HistoryDate> decimalYear(const std::string& text) {
  const Result<double> year = parseNumber(text);
  if (!year || *year < earliestYear || *year > latestYear) return std::nullopt;
  return HistoryDate{text, (*year - 2000) * daysPerYear, HistoryDate::Form::DecimalYear};
}

std::optional<HistoryDate> threeParts(const std::string& text, const Parts& p) {
  std::optional<double> day;
  if (p.lengths[0] == 4)
    day = dayOf(p.numbers[0], p.numbers[1], p.numbers[2]);
  else if (p.lengths[2] == 4 && p.sign != '/')
    day = dayOf(p.numbers[2], p.numbers[1], p.numbers[0]);
  if (!day) return std::nullopt;
  return HistoryDate{text, *day, HistoryDate::Form::Day};
}

std::optional<HistoryDate> twoParts(const std::string& text, const Parts& p) {
  if (p.lengths[0] != 4) return std::nullopt;
  if (parts(".,", p.sign)) return decimalYear(text);
  const std::optional<double> begin = dayOf(p.numbers[0], p.numbers[1], 1);
  if (!begin) return std::nullopt;
  constexpr double halfMonth = daysPerYear / 24;
  return HistoryDate{text, *begin + halfMonth, HistoryDate::Form::Month};
}

std::optional<HistoryDate> onePart(const std::string& text, const Parts& p) {
  if (p.lengths[0] == 8) {
    const auto day = dayOf(p.numbers[0] / 10000, p.numbers[0] / 100 % 100, p.numbers[0] % 100);
    if (day) return HistoryDate{text, *day, HistoryDate::Form::Day};
  }
  if (p.lengths[0] != 4) return std::nullopt;
  const auto begin = dayOf(p.numbers[0], 1, 1);
  if (!begin) return std::nullopt;
  return HistoryDate{text, *begin + daysPerYear / 2, HistoryDate::Form::Year};
}

/// A step of the axis: a number of days or of months.
struct DateStep {
  int days = 0, months = 0;
};

std::string twoDigits(unsigned number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

std::string labelOf(const std::chrono::year_month_day& date, const DateStep& step) {
  std::string label = std::to_string(static_cast<int>(date.year()));
  if (step.months % 12 != 0 || step.days > 0) label += "-" + twoDigits(static_cast<unsigned>(date.month()));
  if (step.days > 0) label += "-" + twoDigits(static_cast<unsigned>(date.day()));
  return label;
}

std::vector<DateTick> ticksOf(const DateStep& step, double from, double to, std::size_t most) {
  using namespace std::chrono;
  std::vector<DateTick> ticks;
  const auto add = [&](sys_days date) {
    const double day = dayOf(date);
    if (day >= from && day <= to) ticks.push_back({day, labelOf(date, step)});
    return day <= to && ticks.size() <= most;
  };
  if (step.days > 0) {
    int day = static_cast<int>(std::ceil(from / step.days)) * step.days;
    while (add(origin + days(day))) day += step.days;
  } else {
    const year_month_day first = floor<days>(origin + days(static_cast<int>(std::floor(from))));
    const int count = 12 * static_cast<int>(first.year()) + static_cast<int>(unsigned(first.month())) - 1;
    int number = count / step.months * step.months;
    while (add(sys_days(year(number / 12) / (number % 12 + 1) / 1))) number += step.months;
  }
  return ticks;
}

}  // namespace

std::vector<DateTick> dateTicks(double from, double to, std::size_t most) {
  std::vector<DateStep> steps;
  for (const int days : {1, 2, 7, 14}) steps.push_back({.days = days});
  for (const int months : {1, 2, 3, 6}) steps.push_back({.months = months});
  for (const int power : {1, 10, 100})
    for (const int years : {1, 2, 5}) steps.push_back({.months = 12 * years * power});
  for (const DateStep& step : steps)
    if (std::vector<DateTick> ticks = ticksOf(step, from, to, most); ticks.size() <= most) return ticks;
  return {};
}

Result<HistoryDate> parseHistoryDate(std::string_view typed) {
  const std::string text = plainSigns(typed);
  const std::string date = text.substr(0, text.find_first_of("T "));
  const std::optional<Parts> parts = partsOf(date);
  if (!parts || !alidade::parts(std::string("-/.,") + '\0', parts->sign)) return noDate(text);
  std::optional<HistoryDate> read;
  if (parts->numbers.size() == 3) read = threeParts(date, *parts);
  if (parts->numbers.size() == 2) read = twoParts(date, *parts);
  if (parts->numbers.size() == 1) read = onePart(date, *parts);
  if (!read) return noDate(text);
  return *std::move(read);
}

HistoryDate asDecimalYear(const HistoryDate& year) {
  HistoryDate decimal = year;
  decimal.day = (std::stoi(year.text) - 2000) * daysPerYear;
  decimal.form = HistoryDate::Form::DecimalYear;
  return decimal;
}

}  // namespace alidade
