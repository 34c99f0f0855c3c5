#include "core/exchange/csv_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/limits.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/csv_table.h"
#include "core/exchange/csv_text.h"
#include "core/exchange/table_beginning.h"
#include "core/exchange/table_plan.h"
#include "core/exchange/table_row.h"
#include "core/exchange/unread_rows.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

/// Does the cell exclude its row? Absent if it says neither yes nor no.
std::optional<bool> flagOf(const std::string& text) {
  const std::string flag = lowerCase(text);
  if (isOneOf(flag, {"1", "yes", "true", "x", "ja", "wahr", "是", "sí", "si", "oui", "да"})) return true;
  if (isOneOf(flag, {"0", "no", "false", "nein", "falsch", "否", "non", "нет"})) return false;
  return std::nullopt;
}

/// Turns "180°" into "180".
std::string axisTextOf(const std::string& text) {
  constexpr std::string_view degree = "°";
  return text.ends_with(degree) ? text.substr(0, text.size() - degree.size()) : text;
}

/// Converts digits of an input method to plain ones: １２ to 12. Names stay unchanged.
std::string plainNumber(std::string text) {
  const bool isPlain = std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  return !isPlain && parseWhole(text) ? plainSigns(text) : text;
}

/// Does the cell contain a digit without beginning with a Latin letter?
bool mayBeReading(const std::string& cell) {
  const char first = cell.empty() ? '\0' : cell.front();
  const bool isWord = (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z');
  return !isWord && hasAnyDigit(cell);
}

/// Determines the kind of circle from the vertical readings if no heading states it.
class CircleKind {
 public:
  void take(const std::string& text) {
    const Result<Angle> angle = parseAngle(text);
    if (!angle) return;
    constexpr double farFromHorizon = 60;
    m_isNegative = m_isNegative || angle->degrees() < 0;
    m_isNearHorizon = m_isNearHorizon && std::abs(angle->degrees()) < farFromHorizon;
  }
  /// Negative readings near the horizon occur only on elevation circles.
  bool isElevation() const { return m_isNegative && m_isNearHorizon; }

 private:
  bool m_isNegative = false, m_isNearHorizon = true;
};

/// Reads a table row by row.
class CsvReader {
 public:
  CsvReader(const TableLayout& layout, const std::string& zeroPoint)
      : m_layout(layout), m_zeroPoint(zeroPoint.empty() ? "zero" : zeroPoint) {}

  Recording read(std::string_view text) {
    m_recording.format = "CSV";
    if (!makePlan(text)) return std::move(m_recording);
    CsvTable table = tableOf(text, m_layout.separator);
    std::size_t rows = 0;
    while (const auto row = table.next()) {
      if (row->isRemark)
        takeRemark(*row);
      else if (++rows > m_layout.headRows + m_plan.rowsBelow)
        readRow(*row);
      if (m_recording.problems.size() >= limits::mostProblems) break;
    }
    if (const auto& problem = table.problem()) {
      m_recording.sightings.clear();
      m_recording.problems = {*problem};
      return std::move(m_recording);
    }
    listRemarks();
    if (const auto line = table.tailLine()) {
      const std::string tail = Phrase::of("content after the end of the file (^Z)");
      m_recording.unused.push_back(Phrase::of("%1 is not used: line %2", tail, *line));
    }
    return std::move(m_recording);
  }

 private:
  void refuse(std::size_t line, std::size_t column, const std::string& what) {
    m_recording.problems.push_back({line, column, what});
  }

  /// Plans the columns. False if the table cannot be read at all.
  bool makePlan(std::string_view text) {
    const TableBeginning beginning = beginningOfTable(text, m_layout.separator, m_layout.headRows);
    if (beginning.problem) {
      m_recording.problems = {*beginning.problem};
      return false;
    }
    const bool isNamed = !beginning.head.empty() || !m_layout.columns.empty();
    if (!isNamed && m_layout.headRows > 0) return false;
    m_plan = planTable(beginning.head, beginning.sample, m_layout);
    if (m_plan.problem) {
      const auto& cells = beginning.nameColumns;
      refuse(std::max<std::size_t>(beginning.nameLine, 1),
             m_plan.problemColumn < cells.size() ? cells[m_plan.problemColumn] : 0, *m_plan.problem);
      return false;
    }
    m_recording.verticalCircle = m_plan.verticalCircle;
    m_unusedCells.resize(m_plan.columns.size());
    m_faces = faceWordsIn(m_plan, beginning.sample);
    return true;
  }

  void takeRemark(const CsvRow& row) {
    if (holdsReading(row)) m_remarksWithReading.push_back(row.line);
  }

  /// Lists what was not used and which assumptions were made.
  void listRemarks() {
    std::vector<std::string>& unused = m_recording.unused;
    unused = unusedSentences(false);
    m_recording.unusedBySession = unusedSentences(true);
    for (const std::string& sentence : m_unread.sentences()) unused.push_back(sentence);
    for (const std::string& sentence : m_counts.sentences()) unused.push_back(sentence);
    if (m_recording.verticalCircle.empty() && m_circleKind.isElevation()) {
      m_recording.verticalCircle = "elevation";
      m_recording.circleRemark =
          Phrase::of("the vertical readings are treated as elevations, because some are negative");
    }
    for (const std::size_t line : m_remarksWithReading)
      unused.push_back(Phrase::of("line %1 begins with # and is not used, though it holds a reading", line));
  }

  /// A sentence for each unused column with values, of known meaning if `isBySession`, of unknown otherwise.
  std::vector<std::string> unusedSentences(bool isBySession) const {
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < m_unusedCells.size(); ++i)
      if (m_unusedCells[i] > 0 && m_plan.columns[i].column.has_value() == isBySession)
        sentences.push_back(
            m_unusedCells[i] == 1
                ? Phrase::of("the column %1 is not used: 1 value", m_plan.nameOf(i))
                : Phrase::of("the column %1 is not used: %2 values", m_plan.nameOf(i), m_unusedCells[i]));
    return sentences;
  }

  void readRow(const CsvRow& row) {
    if (const auto kind = unreadKind(row)) {
      if (*kind == UnreadRows::Kind::NoReading && namesOthers(row))
        return refuse(
            row.line, 0,
            Phrase::of(
                "the columns have other names from here on: put the rows that follow into a separate file"));
      return m_unread.add(*kind, row.line);
    }
    if (const CsvCell* cell = cellBeyond(row))
      return refuse(row.line, cell->column,
                    Phrase::of("%1 is beyond the last named column: name its column, or put the entry that "
                               "contains a separator in double quotes",
                               quotation(cell->text)));
    RecordedSighting sighting;
    sighting.line = row.line;
    for (std::size_t i = 0; i < std::min(row.cells.size(), m_plan.columns.size()); ++i) {
      const CsvCell& cell = row.cells[i];
      const auto& column = m_plan.columns[i].column;
      if (cell.text.empty()) continue;
      if (!column || !column->isOfSession()) ++m_unusedCells[i];
      const bool isAngleCell = column && column->field && isAngle(*column->field);
      if (!column || isAngleCell) continue;
      if (const auto why = readCell(m_plan.columns[i], cell, sighting))
        return refuse(row.line, cell.column, *why);
    }
    if (row.cells.size() > m_plan.columns.size() && isRestOfNote(row)) takeRestOfNote(row, sighting);
    sighting.isZero = isSameName(sighting.row.point, m_zeroPoint);
    addSightings(row, sighting);
  }

  /// Returns the reason why a row is skipped: a mean, or no reading. Absent if the row is read.
  std::optional<UnreadRows::Kind> unreadKind(const CsvRow& row) const {
    using Kind = UnreadRows::Kind;
    if (isOfMean(row)) return Kind::Mean;
    for (const PlannedAngle& angle : m_plan.angles)
      for (const std::size_t at : angle.at)
        if (angle.field->remedy && at < row.cells.size() && mayBeReading(row.cells[at].text))
          return std::nullopt;
    const bool isHeading = std::ranges::any_of(m_plan.headings, [&row](const TableCells& names) {
      return std::ranges::equal(names, row.cells, {}, {}, &CsvCell::text);
    });
    return isHeading ? Kind::HeadingAgain : Kind::NoReading;
  }

  /// Does a row without a reading name both circles? It is then the heading of another table.
  static bool namesOthers(const CsvRow& row) { return nameCircles(row.texts()); }

  /// Does the first cell with a text, the point, the round or the face name a mean?
  bool isOfMean(const CsvRow& row) const {
    bool isFirst = true;
    for (std::size_t i = 0; i < std::min(row.cells.size(), m_plan.columns.size()); ++i) {
      const std::string& text = row.cells[i].text;
      const auto& column = m_plan.columns[i].column;
      if (text.empty()) continue;
      const bool isName = column && (column->isOf(&Reading::point) || column->isOf(&Reading::face) ||
                                     column->isOf(&Reading::round));
      if ((isFirst || isName) && namesMean(text)) return true;
      isFirst = false;
    }
    return false;
  }

  /// The first non-empty cell beyond the named columns if it has a digit; null if it is a remark or absent.
  const CsvCell* cellBeyond(const CsvRow& row) {
    for (std::size_t i = m_plan.columns.size(); i < row.cells.size(); ++i) {
      const std::string& text = row.cells[i].text;
      if (text.empty()) continue;
      if (isRestOfNote(row)) return nullptr;
      if (hasAnyDigit(text)) return &row.cells[i];
      m_counts.add(FileCounts::Kind::Beyond, row.line);
      return nullptr;
    }
    return nullptr;
  }

  /// Do further cells continue a note? Blanks must separate cells, and the note's own cell must lack digits.
  bool isRestOfNote(const CsvRow& row) const {
    const std::size_t last = m_plan.columns.size() - 1;
    const auto& column = m_plan.columns[last].column;
    return m_layout.separator == ' ' && column && column->isOf(&Reading::note) && last < row.cells.size() &&
           !hasAnyDigit(row.cells[last].text);
  }

  void takeRestOfNote(const CsvRow& row, RecordedSighting& sighting) const {
    for (std::size_t i = m_plan.columns.size(); i < row.cells.size(); ++i)
      if (!row.cells[i].text.empty()) sighting.row.note += " " + row.cells[i].text;
  }

  /// Adds one sighting for each face with a reading in the row.
  void addSightings(const CsvRow& row, const RecordedSighting& common) {
    const int faces = m_plan.hasBothFaces ? 2 : 1;
    for (int face = 1; face <= faces; ++face) {
      RecordedSighting sighting = common;
      const int stated = m_plan.hasBothFaces ? face : m_plan.face;
      if (stated > 0 && (m_plan.hasBothFaces || sighting.row.face.empty()))
        sighting.row.face = std::to_string(stated);
      bool isAny = !m_plan.hasBothFaces;
      for (const PlannedAngle& angle : m_plan.angles) {
        if (m_plan.hasBothFaces && angle.field->remedy && angle.isFaceTwo != (face == 2)) continue;
        const Result<bool> isRead = readAngle(angle, row, sighting);
        if (!isRead) return refuse(row.line, columnOf(angle, row), isRead.problem().what);
        isAny = isAny || (*isRead && angle.field->remedy);
      }
      if (isAny) m_recording.sightings.push_back(std::move(sighting));
    }
  }

  static std::size_t columnOf(const PlannedAngle& angle, const CsvRow& row) {
    return angle.at[0] < row.cells.size() ? row.cells[angle.at[0]].column : 0;
  }

  /// Enters an angle in the sighting. True if the row has this angle.
  Result<bool> readAngle(const PlannedAngle& angle, const CsvRow& row, RecordedSighting& sighting) {
    if (const auto problem = otherSignIn(angle, row)) return *problem;
    Result<FileAngle> read = angleIn(angle, cellTexts(angle, row), m_layout.unit);
    if (!read) return read.problem();
    FileAngle found = *std::move(read);
    if (found.text.empty()) return false;
    if (found.isCarried) m_counts.add(FileCounts::Kind::Carried, row.line);
    if (found.isFullCircle) m_counts.add(FileCounts::Kind::FullCircle, row.line);
    if (angle.field->text == &Reading::vertical) m_circleKind.take(found.text);
    sighting.enter(*angle.field, std::move(found.text), columnOf(angle, row));
    return true;
  }

  static std::array<std::string, 3> cellTexts(const PlannedAngle& angle, const CsvRow& row) {
    std::array<std::string, 3> texts;
    for (std::size_t part = 0; part < texts.size(); ++part)
      if (angle.at[part] < row.cells.size()) texts[part] = fromPlainCell(row.cells[angle.at[part]].text);
    return texts;
  }

  std::optional<Problem> otherSignIn(const PlannedAngle& angle, const CsvRow& row) const {
    if (m_layout.decimalSign == DecimalSign::Either) return std::nullopt;
    const char other = m_layout.decimalSign == DecimalSign::Point ? ',' : '.';
    for (const std::size_t at : angle.at)
      if (at < row.cells.size() && row.cells[at].text.find(other) != std::string::npos)
        return Problem{Phrase::of(
            "%1 has a decimal sign other than the one stated: state the right sign, or allow either",
            quotation(row.cells[at].text))};
    return std::nullopt;
  }

  /// Does a row that is skipped hold readings of both circles?
  bool holdsReading(const CsvRow& row) const {
    std::size_t circles = 0, read = 0;
    for (const PlannedAngle& angle : m_plan.angles) {
      if (!angle.field->remedy || angle.isFaceTwo) continue;
      ++circles;
      const Result<FileAngle> text = angleIn(angle, cellTexts(angle, row), m_layout.unit);
      read += text && parseAngle(text->text) ? 1 : 0;
    }
    return circles > 0 && read == circles;
  }

  /// Returns the reason why the cell cannot be used; absent if it can.
  std::optional<std::string> readCell(const ColumnName& column, const CsvCell& cell,
                                      RecordedSighting& sighting) {
    const RowField* field = column.column->field;
    if (!column.column->isOfSession()) {
      takeOther(column, cell, sighting);
    } else if (!field && column.column->other == TableColumn::Other::Turn) {
      const Result<int> turn = parseWhole(cell.text);
      if (!turn || *turn < 1)
        return Phrase::of("%1 is no turn: turns of the axis are numbered from 1", quotation(cell.text));
      sighting.repeat = *turn;
      m_recording.hasTurns = true;
    } else if (!field) {
      sighting.axis = {axisTextOf(fromPlainCell(cell.text)), cell.column};
    } else if (field->text) {
      const std::string text = plainNumber(fromPlainCell(cell.text));
      sighting.enter(*field, field->text == &Reading::face ? m_faces.of(text) : text, cell.column);
    } else {
      const auto flag = flagOf(cell.text);
      if (!flag) return Phrase::of("%1 is neither yes nor no: type one of them", quotation(cell.text));
      sighting.row.*field->flag = *flag;
    }
    return std::nullopt;
  }

  /// Enters the station or the distance.
  void takeOther(const ColumnName& column, const CsvCell& cell, RecordedSighting& sighting) {
    if (column.column->other == TableColumn::Other::Station) {
      sighting.station = m_recording.stationNamed(fromPlainCell(cell.text));
      return;
    }
    const Result<double> number = parseNumber(cell.text);
    if (number && *number > 0) {
      sighting.distanceM = *number * column.metres;
      sighting.isDistanceHorizontal = column.isHorizontal;
    } else if (!number || *number < 0) {
      m_recording.distanceProblems.push_back(
          {sighting.line, cell.column,
           Phrase::of("%1 is no distance: type a length in metres, or leave it empty",
                      quotation(cell.text))});
    }
  }

  const TableLayout& m_layout;
  std::string m_zeroPoint;
  TablePlan m_plan;
  FaceWords m_faces;
  std::vector<std::size_t> m_unusedCells;
  UnreadRows m_unread;
  FileCounts m_counts;
  CircleKind m_circleKind;
  std::vector<std::size_t> m_remarksWithReading;  ///< line numbers
  Recording m_recording;
};

}  // namespace

Recording readTable(std::string_view text, const TableLayout& layout, const std::string& zeroPoint) {
  const auto plain = withPlainSeparators(text);
  return CsvReader(layout, zeroPoint).read(plain ? std::string_view(*plain) : text);
}

}  // namespace alidade
