#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace alidade {

/// A day as written, and its place in time.
struct HistoryDate {
  std::string text;  ///< as written, without surrounding blanks
  double day = 0;    ///< days from 2000-01-01 0 h; the middle of a whole month or year
  enum class Form { Day, Month, Year, DecimalYear } form = Form::Day;
};

/// Days of a year, for trends.
inline constexpr double daysPerYear = 365.25;

/// Reads `2019-03-07`, `2019/3/7`, `2019.03.07`, `20190307`, `7.3.2019`, each perhaps followed by a time of
/// day (which is ignored), `2019-03`, `2019` and the decimal year `2019.18` or `2019,18`. Refuses the
/// ambiguous `3/7/2019`.
Result<HistoryDate> parseHistoryDate(std::string_view text);

/// A mark on an axis of dates: "2025-03-07", "2025-03" at the first of a month, "2025" at the first of a
/// year.
struct DateTick {
  double day = 0;  ///< days from 2000-01-01
  std::string label;
};

/// Calendar dates between two days, at most `most` (≥ 1). Their step is the smallest of 1, 2, 7 or 14 days,
/// 1, 2, 3 or 6 months, or 1, 2, 5, 10, … years that fits `most`. Both days must be between 1500 and 2200.
/// The result may be empty.
std::vector<DateTick> dateTicks(double from, double to, std::size_t most);

/// A whole year reinterpreted as a decimal year: 2019 then means its beginning, 2019.0.
HistoryDate asDecimalYear(const HistoryDate& year);

}  // namespace alidade
