#include "core/diagnosis/forms/residual_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/csv_table.h"
#include "core/exchange/text_lines.h"
#include "core/exchange/words.h"

namespace alidade {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr std::size_t fewestRows = 12, mostRows = 20'000, mostBases = 200;

using Column = std::vector<double>;

class ResidualReader {
 public:
  explicit ResidualReader(const std::string& text) : m_table(text) {}

  Result<ResidualTable> read() {
    while (const std::optional<CsvRow> row = m_table.next()) {
      if (row->isRemark) continue;
      const std::optional<Problem> problem = m_places.empty() ? readHead(*row) : readRow(*row);
      if (problem) return *problem;
    }
    if (m_table.problem()) return Problem{m_table.problem()->text()};
    if (m_rows < fewestRows)
      return Problem{
          Phrase::of("The table has %1 rows of residuals: forms need at least %2.", m_rows, fewestRows)};
    return table();
  }

 private:
  CsvTable m_table;
  std::map<std::string, std::size_t> m_places;  ///< index in the row of each column that is used
  std::vector<std::string> m_bases;
  std::map<std::string, Column> m_columns;
  std::vector<bool> m_isHorizontal;
  std::size_t m_rows = 0;

  std::optional<Problem> readHead(const CsvRow& row) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string name = trimmed(row.cells[i].text), key = lowerCase(name);
      const bool isBase = key.starts_with("base:");
      if (!isBase && !isOneOf(key, {"residual_arcsec", "sigma_arcsec", "circle", "azimuth_deg",
                                    "elevation_deg", "time", "leg", "face"}))
        continue;
      if (!m_places.emplace(isBase ? name : key, i).second)
        return Problem{Phrase::of("Line %1: the column %2 occurs twice. Remove one of them.", row.line,
                                  quotation(name))};
      if (isBase) m_bases.push_back(name);
    }
    if (m_bases.size() > mostBases)
      return Problem{
          Phrase::of("The table has %1 base columns: at most %2 are read.", m_bases.size(), mostBases)};
    for (const char* needed : {"residual_arcsec", "sigma_arcsec", "circle", "azimuth_deg", "elevation_deg"})
      if (!m_places.contains(needed))
        return Problem{
            Phrase::of("Line %1: there is no column %2. The first row names the columns: "
                       "residual_arcsec, sigma_arcsec, circle, azimuth_deg, elevation_deg.",
                       row.line, needed)};
    return std::nullopt;
  }

  std::string cell(const CsvRow& row, const std::string& name) const {
    const std::size_t place = m_places.at(name);
    return place < row.cells.size() ? trimmed(row.cells[place].text) : std::string();
  }

  std::optional<Problem> readRow(const CsvRow& row) {
    if (++m_rows > mostRows)
      return Problem{Phrase::of("The table has more than %1 rows: leave some of them out.", mostRows)};
    const std::string circle = lowerCase(cell(row, "circle"));
    if (!isOneOf(circle, {"horizontal", "vertical"}))
      return Problem{Phrase::of("Line %1: the circle %2 is unknown. Enter horizontal or vertical.", row.line,
                                quotation(cell(row, "circle")))};
    m_isHorizontal.push_back(circle == "horizontal");
    for (const auto& [name, place] : m_places) {
      if (name == "circle") continue;
      const std::string text = cell(row, name);
      const std::optional<double> value = name == "leg" ? legOf(text) : numberIn(text);
      if (!value)
        return Problem{Phrase::of("Line %1: %2 is %3, which is no number. Correct it or leave the row out.",
                                  row.line, name, quotation(text))};
      if (auto problem = outOfRange(row, name, *value)) return problem;
      m_columns[name].push_back(*value);
    }
    return std::nullopt;
  }

  static std::optional<double> numberIn(const std::string& text) {
    const Result<double> number = parseNumber(plainSigns(text));
    return number ? std::optional(*number) : std::nullopt;
  }

  /// 1 for the way there, −1 for the way back.
  static std::optional<double> legOf(const std::string& text) {
    const std::string word = lowerCase(text);
    if (isOneOf(word, {"there", "out", "up", "forward", "1", "+1"})) return 1;
    if (isOneOf(word, {"back", "return", "down", "backward", "2", "-1", "0"})) return -1;
    return std::nullopt;
  }

  static std::optional<Problem> outOfRange(const CsvRow& row, const std::string& name, double value) {
    constexpr double large = 1e9;
    const auto refused = [&](const char* range) {
      return Problem{Phrase::of("Line %1: %2 is %3, outside %4. Correct it or leave the row out.", row.line,
                                name, shortestText(value), range)};
    };
    if (name == "sigma_arcsec" && !(value > 1e-9 && value < large)) return refused("0 … 1e9");
    if (name == "elevation_deg" && std::abs(value) > 90) return refused("−90° … 90°");
    if (name == "azimuth_deg" && std::abs(value) > 720) return refused("−720° … 720°");
    if (name == "face" && value != 1 && value != 2) return refused("1 … 2");
    if (std::abs(value) > large) return refused("−1e9 … 1e9");
    return std::nullopt;
  }

  VectorXd values(const std::string& name) const {
    const Column& column = m_columns.at(name);
    return Eigen::Map<const VectorXd>(column.data(), std::ssize(column));
  }

  static void set(FormReadings& readings, FormArgument of, VectorXd values) {
    if (values.maxCoeff() > values.minCoeff())
      readings.arguments[static_cast<std::size_t>(of)] = std::move(values);
  }

  ResidualTable table() const {
    constexpr double perDegree = std::numbers::pi / 180;
    ResidualTable table;
    table.sigma = values("sigma_arcsec");
    table.residual = values("residual_arcsec").cwiseQuotient(table.sigma);
    FormReadings& readings = table.readings;
    readings.count = table.sigma.size();
    VectorXd horizontal = VectorXd::Zero(readings.count), vertical = horizontal;
    for (Index i = 0; i < readings.count; ++i)
      (m_isHorizontal[static_cast<std::size_t>(i)] ? horizontal : vertical)[i] = 1 / table.sigma[i];
    const auto carry = [&](FormCarrier carrier) -> VectorXd& {
      return readings.carriers[static_cast<std::size_t>(carrier)];
    };
    if (!horizontal.isZero() && !vertical.isZero()) carry(FormCarrier::Orientation) = horizontal + vertical;
    if (!horizontal.isZero()) carry(FormCarrier::Horizontal) = horizontal;
    if (!vertical.isZero()) carry(FormCarrier::Vertical) = vertical;
    set(readings, FormArgument::Azimuth, perDegree * values("azimuth_deg"));
    set(readings, FormArgument::Elevation, perDegree * values("elevation_deg"));
    addOptional(readings);
    table.base.resize(readings.count, std::ssize(m_bases));
    for (Index b = 0; const std::string& name : m_bases)
      table.base.col(b++) = values(name).cwiseQuotient(table.sigma);
    return table;
  }

  void addOptional(FormReadings& readings) const {
    readings.face = VectorXd::Ones(readings.count);
    if (m_columns.contains("face")) {
      readings.face = 3 - 2 * values("face").array();
      set(readings, FormArgument::Face, readings.face);
    }
    if (m_columns.contains("leg")) set(readings, FormArgument::Leg, values("leg"));
    if (!m_columns.contains("time")) return;
    const VectorXd time = values("time");
    const double range = time.maxCoeff() - time.minCoeff();
    if (range > 0) set(readings, FormArgument::T, (time.array() - time.minCoeff()) / range);
  }
};

}  // namespace

Result<ResidualTable> readResiduals(std::string_view bytes) {
  const Result<std::string> text = utf8Text(bytes);
  if (!text) return text.problem();
  return ResidualReader(*text).read();
}

}  // namespace alidade
