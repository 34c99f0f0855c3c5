#include "core/series/history/value_columns.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

bool holdsAny(std::string_view text, std::initializer_list<std::string_view> parts) {
  return std::ranges::any_of(
      parts, [&](std::string_view part) { return text.find(part) != std::string_view::npos; });
}

bool namesDate(const std::string& name) {
  return holdsAny(name, {"date", "year", "epoch", "datum", "jahr", "month", "日期", "年", "时间"}) ||
         isOneOf(name, {"time", "t", "when", "day"});
}

bool namesExpanded(const std::string& name) {
  return holdsAny(name, {"expanded", "erweitert", "扩展"});
}

/// The coverage factor that a heading states as `k=2` or `k = 2.5`.
std::optional<double> factorIn(const std::string& name) {
  std::string plain = name;
  std::erase(plain, ' ');
  const std::size_t at = plain.find("k=");
  if (at == std::string::npos) return std::nullopt;
  const std::size_t end = plain.find_first_not_of("0123456789.,", at + 2);
  const Result<double> factor = parseNumber(plain.substr(at + 2, end - at - 2));
  return factor && *factor > 0 ? std::optional(*factor) : std::nullopt;
}

/// Does the heading begin with the symbol of an expanded uncertainty, as in `U`, `U (mm)`, `U95`?
bool beginsWithU(const std::string& written) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return written.starts_with('U') && (written.size() == 1 || !isLetter(written[1]));
}

bool namesUncertainty(const std::string& name) {
  return namesExpanded(name) || name.starts_with("u9") || (name.starts_with("u") && factorIn(name)) ||
         holdsAny(name,
                  {"uncert", "unsich", "sigma", "error", "standard dev", "std", "不确定度", "σ", "±"}) ||
         isOneOf(name, {"u", "s", "sd", "se", "unc", "err", "unc."}) || name.starts_with("u(") ||
         name.starts_with("u_") || name.starts_with("u ") || name.starts_with("s_") || name.starts_with("u/");
}

bool namesValue(const std::string& name) {
  return holdsAny(name, {"value", "wert", "result", "mean", "delta_d", "Δd", "intersection", "值"}) ||
         isOneOf(name, {"x", "y"});
}

std::string unitIn(const std::string& name) {
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const std::size_t to = name.rfind(close), from = name.rfind(open, to);
    if (from != std::string::npos && to != std::string::npos)
      return trimmed(std::string_view(name).substr(from + 1, to - from - 1));
  }
  return {};
}

std::string withoutUnit(const std::string& name) {
  return trimmed(std::string_view(name).substr(0, name.find_first_of("[(")));
}

/// The unit in a form for comparing: the signs of arcsecond, degree and micro are written in several ways.
std::string plainUnit(const std::string& written) {
  const std::string unit = lowerCase(plainSigns(written));
  if (isOneOf(unit, {"\"", "''", "arcsec", "arcsecond", "arcseconds"})) return "arcsec";
  if (isOneOf(unit, {"°", "deg", "degree", "degrees"})) return "deg";
  if (isOneOf(unit, {"µm", "μm", "um"})) return "um";
  return unit;
}

/// False for what may be in the brackets instead of a unit: `k = 2`, `95 %`, `1σ`, or the value in `u(x)`.
bool isUnit(const std::string& bracketed, const std::string& value) {
  return !bracketed.empty() && !isDigit(bracketed.front()) && bracketed != withoutUnit(value) &&
         !holdsAny(bracketed, {"=", "σ", "sigma", "standard", "std"});
}

class ColumnFinder {
 public:
  ColumnFinder(const std::vector<std::string>& names, const std::vector<ColumnContent>& contents)
      : m_names(names), m_contents(contents) {}

  Result<ValueColumns> find() {
    sortByNames();
    const auto isFree = [&](std::size_t i) { return !contains(m_named, i); };
    for (std::size_t i = 0; !m_columns.date && i < m_contents.size(); ++i)
      if (isFree(i) && m_contents[i].isDate) m_columns.date = i;
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < m_contents.size(); ++i)
      if (isFree(i) && m_columns.date != i && m_contents[i].isNumber) left.push_back(i);
    shareOut(left);
    if (auto problem = ambiguity()) return *std::move(problem);
    if (!m_values.empty()) m_columns.value = m_values.front();
    if (!m_us.empty()) m_columns.u = m_us.front();
    return judged();
  }

 private:
  const std::vector<std::string>& m_names;
  const std::vector<ColumnContent>& m_contents;
  ValueColumns m_columns;
  std::vector<std::size_t> m_values, m_us;  ///< columns that could be the value or u
  std::vector<std::size_t> m_named;         ///< columns whose names mean a value or an uncertainty

  static bool contains(const std::vector<std::size_t>& columns, std::size_t column) {
    return std::ranges::find(columns, column) != columns.end();
  }

  void sortByNames() {
    for (std::size_t i = 0; i < m_names.size(); ++i) {
      const std::string name = lowerCase(m_names[i]);
      if (!m_columns.date && namesDate(name))
        m_columns.date = i;
      else if (namesUncertainty(name))
        m_us.push_back(i);
      else if (namesValue(name))
        m_values.push_back(i);
    }
    m_named = m_values;
    m_named.insert(m_named.end(), m_us.begin(), m_us.end());
    prefer(m_values, {"value", "Value"});
    prefer(m_us, {"u"});  // not "U": the same table may hold the expanded uncertainty as well
  }

  /// Keeps only the columns with exactly one of these names, if there are any.
  void prefer(std::vector<std::size_t>& columns, std::initializer_list<std::string_view> exact) const {
    const auto isOther = [&](std::size_t i) { return !isOneOf(withoutUnit(m_names[i]), exact); };
    if (!std::ranges::all_of(columns, isOther)) std::erase_if(columns, isOther);
  }

  /// Makes the columns of numbers without a known name the value and u.
  void shareOut(const std::vector<std::size_t>& left) {
    const bool isNamed = !m_values.empty();
    const auto isPlain = [&](std::size_t i) {
      return i >= m_contents.size() || !m_contents[i].hasUncertainty;
    };
    if (!isNamed) {
      m_values = left;
      if (!std::ranges::all_of(left, isPlain)) std::erase_if(m_values, isPlain);
    }
    if (!m_us.empty() || m_values.empty() || !isPlain(m_values.front())) return;
    if (isNamed) {
      m_us = left;
    } else if (left.size() == 2) {
      m_us = {left.back()};
      m_values.pop_back();
    }
  }

  std::optional<Problem> ambiguity() const {
    if (m_values.size() > 1)
      return Problem{
          Phrase::of("each of the columns %1 could hold the value: name only one of them “value” "
                     "in the first line",
                     labels(m_values))};
    if (m_us.size() > 1)
      return Problem{
          Phrase::of("each of the columns %1 could hold the standard uncertainty: name only one "
                     "of them “u” in the first line",
                     labels(m_us))};
    return std::nullopt;
  }

  std::string nameOf(std::optional<std::size_t> column) const {
    return column && *column < m_names.size() ? m_names[*column] : std::string();
  }

  /// The names of the columns, or their numbers from 1.
  std::string labels(const std::vector<std::size_t>& columns) const {
    std::vector<std::string> labels;
    for (const std::size_t i : columns)
      labels.push_back(nameOf(i).empty() ? std::to_string(i + 1) : quotation(nameOf(i)));
    return listed(labels, Phrase::of(" and "));
  }

  /// The columns, with what their names say about their numbers.
  Result<ValueColumns> judged() {
    const std::string value = nameOf(m_columns.value), u = nameOf(m_columns.u), ofU = unitIn(u);
    m_columns.unit = unitIn(value);
    if (!m_columns.unit.empty() && isUnit(ofU, value) && plainUnit(ofU) != plainUnit(m_columns.unit))
      return Problem{
          Phrase::of("the columns %1 and %2 state different units: give the value and its uncertainty in one "
                     "unit",
                     quotation(value), quotation(u))};
    const std::string name = lowerCase(u);
    const bool isExpanded = namesExpanded(name) || (beginsWithU(u) && holdsAny(name, {"9", "%"}));
    m_columns.factor = factorIn(name).value_or(isExpanded ? 2 : 1);
    if (m_columns.factor != 1)
      m_columns.remark = Phrase::of(
          "the column %1 holds expanded uncertainties: each is divided by %2 to give the standard "
          "uncertainty",
          quotation(u), displayShortest(m_columns.factor));
    else if (beginsWithU(u) && !factorIn(name))
      m_columns.remark = Phrase::of(
          "the column %1 is read as standard uncertainties (k = 1): halve the values if they are expanded",
          quotation(u));
    return m_columns;
  }
};

}  // namespace

Result<ValueColumns> valueColumns(const std::vector<std::string>& names,
                                  const std::vector<ColumnContent>& contents) {
  return ColumnFinder(names, contents).find();
}

}  // namespace alidade
