#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace alidade {

/// A day as somebody wrote it, and where it lies in time.
struct HistoryDate {
  std::string text;  ///< as written, blanks around taken off
  double day = 0;    ///< days from 2000-01-01 0 h; of a whole month or year its middle
  enum class Form { Day, Month, Year, DecimalYear } form = Form::Day;
};

/// Days of a year: by which trends are told.
inline constexpr double daysPerYear = 365.25;

/// Reads `2019-03-07`, `2019/3/7`, `2019.03.07`, `20190307`, `7.3.2019`, each perhaps with a time of day
/// behind it (which is left out), `2019-03`, `2019` and the decimal year `2019.18` or `2019,18`. Not
/// `3/7/2019`, which means two days.
Result<HistoryDate> parseHistoryDate(std::string_view text);

/// The same year read as a decimal one: 2019 is the beginning of it, as 2019.0 is.
HistoryDate asDecimalYear(const HistoryDate& year);

/// The year and its part, to three places; to tell dates apart on an axis.
double decimalYearOf(double day);

}  // namespace alidade
