#include "core/exchange/table_plan.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/circle_numbers.h"
#include "core/exchange/heading_words.h"
#include "core/exchange/table_headings.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

constexpr double minutesInDegree = 60;

bool isDegreesOfCircle(const ColumnName& name) {
  return name.column && name.column->isCircle() && name.column->part == AnglePart::Degrees;
}

/// The column of the whole angle to which the column's part belongs.
TableColumn wholeOf(TableColumn column) {
  column.part = AnglePart::Degrees;
  return column;
}

/// Makes the plan of one table.
class TablePlanner {
 public:
  TablePlanner(const std::vector<TableCells>& head, const std::vector<TableCells>& sample,
               const TableLayout& layout)
      : m_layout(layout), m_headings(head, sample) {
    m_rows.assign(sample.begin() + static_cast<std::ptrdiff_t>(m_headings.rowsBelow()), sample.end());
    m_plan.rowsBelow = m_headings.rowsBelow();
    m_plan.headings = m_headings.rows();
  }

  TablePlan plan() {
    nameColumns();
    if (m_layout.columns.empty()) {
      inheritParts();
      for (std::size_t i = 0; i < m_plan.columns.size(); ++i) joinByNumbers(i);
      dropWeak();
      takeSeries();
    }
    determineFaces();
    if (!m_plan.problem) findTwice();
    if (!m_plan.problem) makeAngles();
    if (!m_plan.problem) findMissing();
    if (!m_plan.problem) findLostParts();
    if (!m_plan.problem) findLostSigns();
    if (!m_plan.problem) takeGrad();
    return std::move(m_plan);
  }

 private:
  using Columns = std::vector<ColumnName>;

  void refuse(std::size_t column, std::string why) {
    if (m_plan.problem) return;
    m_plan.problem = std::move(why);
    m_plan.problemColumn = column;
  }

  void nameColumns() {
    const std::size_t count = std::max(m_headings.width(), m_layout.columns.size());
    for (std::size_t i = 0; i < count; ++i) {
      ColumnName name = m_headings.nameOf(i);
      if (!m_layout.columns.empty()) {
        name.column = i < m_layout.columns.size() ? tableColumn(m_layout.columns[i]) : std::nullopt;
        if (name.column && statesFaceTwo()) name.face = name.column->isFaceTwo ? 2 : 1;
      }
      m_plan.names.push_back(m_headings.writtenName(i));
      m_plan.columns.push_back(std::move(name));
    }
  }

  /// Do the chosen columns include both faces?
  bool statesFaceTwo() const {
    return std::ranges::any_of(m_layout.columns, [](const std::string& key) {
      const auto column = tableColumn(key);
      return column && column->isFaceTwo;
    });
  }

  bool has(const TableColumn& column, int face) const {
    return std::ranges::any_of(
        m_plan.columns, [&](const ColumnName& name) { return name.column == column && name.face == face; });
  }

  /// Gives a part without a circle to the circle to its left, as in `Hz (°)`, `(')`, `(")`.
  void inheritParts() {
    Columns& columns = m_plan.columns;
    for (std::size_t i = 1; i < columns.size(); ++i) {
      ColumnName& name = columns[i];
      const ColumnName& before = columns[i - 1];
      const bool isNext = before.column && before.column->isCircle() && name.isUnderstood && name.isPart &&
                          static_cast<int>(name.part) == static_cast<int>(before.column->part) + 1;
      const bool isLetter = isOneOf(m_plan.names[i], {"S", "s"}) &&
                            isOneOf(m_plan.names[i - 1], {"M", "m"}) && before.column &&
                            before.column->isCircle();
      if (name.column && !isLetter) continue;
      if (!isNext && !isLetter) continue;
      name.column = before.column;
      name.column->part = isLetter ? AnglePart::Seconds : name.part;
      name.face = before.face;
      name.isWeak = before.isWeak;
      name.isCentesimal = name.isCentesimal || before.isCentesimal;
    }
  }

  /// Joins columns that have no name or repeat the circle's name, if their numbers are degrees, minutes and
  /// seconds.
  void joinByNumbers(std::size_t at) {
    Columns& columns = m_plan.columns;
    const ColumnName first = columns[at];
    if (!isDegreesOfCircle(first)) return;
    const auto isSame = [&](std::size_t i) {
      if (i >= m_headings.width() || i >= columns.size()) return false;
      return m_headings.isBlank(i) ||
             (columns[i].column == first.column && m_plan.names[i] == m_plan.names[at]);
    };
    std::size_t same = 1;
    while (same < 3 && isSame(at + same)) ++same;
    const std::size_t count = std::min(same, joinableAt(m_rows, at));
    for (std::size_t i = 1; i < count; ++i) {
      ColumnName& name = columns[at + i];
      name = first;
      name.column->part = static_cast<AnglePart>(i);
      name.unit = AngleUnit::Unstated;
    }
  }

  /// An ambiguous heading gives way to a clear one for the same field.
  void dropWeak() {
    std::vector<TableColumn> strong;
    for (const ColumnName& name : m_plan.columns)
      if (name.column && !name.isWeak) strong.push_back(wholeOf(*name.column));
    const bool hasCoordinates = std::ranges::any_of(m_plan.names, [](const std::string& name) {
      return isOneOf(lowerCase(name), {"x", "y"});
    });
    for (ColumnName& name : m_plan.columns) {
      if (hasCoordinates && name.isWeak && name.column && name.column->isOf(&Reading::vertical))
        name.column.reset();
      const bool isTaken =
          name.isWeak && name.column && std::ranges::find(strong, wholeOf(*name.column)) != strong.end();
      if (isTaken) name.column.reset();
    }
    std::set<std::string> keys;
    for (ColumnName& name : m_plan.columns)
      if (name.column && !name.column->isOfSession() && !keys.insert(name.column->key()).second)
        name.column.reset();
  }

  /// Makes `series` the station if another column names the round.
  void takeSeries() {
    if (!m_layout.seriesIsStation || has({nullptr, TableColumn::Other::Station}, 0)) return;
    std::vector<std::size_t> rounds;
    for (std::size_t i = 0; i < m_plan.columns.size(); ++i)
      if (m_plan.columns[i].column && m_plan.columns[i].column->isOf(&Reading::round)) rounds.push_back(i);
    if (rounds.size() != 2) return;
    for (const std::size_t i : rounds)
      if (lowerCase(m_plan.names[i]) == "series")
        m_plan.columns[i].column = TableColumn{nullptr, TableColumn::Other::Station};
  }

  std::set<int> facesOf(std::string Reading::*circle) const {
    std::set<int> faces;
    for (const ColumnName& name : m_plan.columns)
      if (name.column && name.column->isOf(circle)) faces.insert(name.face);
    return faces;
  }

  /// Face words count only if the headings of both circles name the same faces. Otherwise the words mean
  /// something else, as V1 in an M5 file.
  void determineFaces() {
    std::set<int> horizontal = facesOf(&Reading::horizontal), vertical = facesOf(&Reading::vertical);
    for (std::set<int>* faces : {&horizontal, &vertical})
      if (faces->contains(2) && faces->contains(0) && !faces->contains(1)) {
        faces->erase(0);
        faces->insert(1);
      }
    const std::set<int> both{1, 2};
    m_plan.hasBothFaces = horizontal == both && (vertical == both || vertical.empty());
    if (horizontal == both && !m_plan.hasBothFaces)
      return refuse(
          0, Phrase::of("the columns hold the horizontal circle in both faces and the vertical in one: "
                        "name the columns of both faces, such as V I and V II"));
    if (vertical == both && !m_plan.hasBothFaces)
      return refuse(
          0, Phrase::of("the columns hold the vertical circle in both faces and the horizontal in one: "
                        "name the columns of both faces, such as Hz I and Hz II"));
    const bool isOneFace = horizontal.size() == 1 && (vertical.empty() || vertical == horizontal);
    if (!m_plan.hasBothFaces && isOneFace) m_plan.face = *horizontal.begin();
    for (ColumnName& name : m_plan.columns)
      if (name.column && name.column->field) {
        name.column->isFaceTwo = m_plan.hasBothFaces && name.column->isCircle() && name.face == 2;
        name.face = name.column->isFaceTwo ? 2 : 0;
      }
  }

  /// The heading of a column in quotation marks, or "column 3", as the subject of a sentence.
  std::string subjectOf(std::size_t i) const {
    const bool isNamed = i < m_plan.names.size() && !m_plan.names[i].empty();
    return isNamed ? quotation(m_plan.names[i]) : Phrase::of("column %1", i + 1);
  }

  void findTwice() {
    std::set<std::string> seen;
    for (std::size_t i = 0; i < m_plan.columns.size(); ++i) {
      const auto& column = m_plan.columns[i].column;
      if (!column || seen.insert(column->key()).second) continue;
      return refuse(i, Phrase::of("%1 is a second column for “%2”: rename or remove one of the two",
                                  subjectOf(i), wholeOf(*column).key()));
    }
  }

  void makeAngles() {
    for (std::size_t i = 0; i < m_plan.columns.size(); ++i) {
      const ColumnName& name = m_plan.columns[i];
      if (!name.column || !name.column->field || !isAngle(*name.column->field)) continue;
      auto found = std::ranges::find_if(m_plan.angles, [&](const PlannedAngle& angle) {
        return angle.field == name.column->field && angle.isFaceTwo == name.column->isFaceTwo;
      });
      if (found == m_plan.angles.end()) {
        m_plan.angles.push_back({.field = name.column->field, .isFaceTwo = name.column->isFaceTwo});
        found = m_plan.angles.end() - 1;
      }
      found->at[static_cast<std::size_t>(name.column->part)] = i;
      if (name.column->part == AnglePart::Degrees) found->unit = name.unit;
      found->isCentesimal = found->isCentesimal || name.isCentesimal;
      const bool namesCircle = name.column->isOf(&Reading::vertical) && !name.verticalCircle.empty();
      if (namesCircle) m_plan.verticalCircle = name.verticalCircle;
    }
    for (PlannedAngle& angle : m_plan.angles) checkParts(angle);
  }

  void checkParts(PlannedAngle& angle) {
    const auto [degrees, minutes, seconds] = angle.at;
    const bool isIncomplete =
        degrees == PlannedAngle::none || (seconds != PlannedAngle::none && minutes == PlannedAngle::none);
    const std::size_t column = seconds != PlannedAngle::none ? seconds : minutes;
    if (isIncomplete)
      return refuse(column,
                    Phrase::of("%1 holds a part of an angle whose degrees or minutes have no column: name "
                               "their columns, such as Hz deg, Hz min, Hz sec",
                               m_plan.nameOf(column)));
    if (!angle.isJoined()) return;
    const std::vector<std::string> words = headingWords(m_plan.names[degrees]);
    const bool isLetter = !words.empty() && words.back() == "g";  // g of grados
    if (isLetter && angle.unit == AngleUnit::Gon && hasSexagesimal(angle)) angle.unit = AngleUnit::Degrees;
    const bool isGon = angle.unit == AngleUnit::Gon ||
                       (angle.unit == AngleUnit::Unstated && m_layout.unit == AngleUnit::Gon);
    const bool isOther =
        angle.unit == AngleUnit::Radians || (angle.isCentesimal && angle.unit == AngleUnit::Degrees) ||
        (isGon && !angle.isCentesimal && angle.unit == AngleUnit::Gon && hasSexagesimal(angle));
    if (isOther)
      return refuse(degrees, Phrase::of("%1 and the columns of its parts have incompatible units: name them "
                                        "deg, min and sec, or g, c and cc",
                                        m_plan.nameOf(degrees)));
    angle.isCentesimal = angle.isCentesimal || isGon;
  }

  /// Does the angle have a column named as minutes or seconds of a degree?
  bool hasSexagesimal(const PlannedAngle& angle) const {
    return std::any_of(angle.at.begin() + 1, angle.at.end(), [this](std::size_t at) {
      return at != PlannedAngle::none && m_plan.columns[at].isPart && !m_plan.columns[at].isCentesimal;
    });
  }

  bool hasAngle(std::string_view key) const {
    return std::ranges::any_of(m_plan.angles,
                               [key](const PlannedAngle& angle) { return angle.field->key == key; });
  }

  void findMissing() {
    for (const RowField& field : rowFields) {
      const bool isNeeded = field.remedy && m_layout.needsCircles &&
                            (field.text != &Reading::vertical || m_layout.needsVertical);
      if (!isNeeded || hasAngle(field.key)) continue;
      refuse(PlannedAngle::none, Phrase::of("no column is named “%1”: begin with a row of names such as "
                                            "axis;point;face;horizontal;vertical",
                                            field.key));
    }
  }

  /// Refuses whole degrees next to an unnamed column that may hold their minutes: the reading would lose the
  /// minutes. Most cells decide, so that no single cell of another kind hides the loss.
  void findLostParts() {
    for (const PlannedAngle& angle : m_plan.angles) {
      const std::size_t at = angle.at[0];
      const bool mayBeDegrees = angle.unit == AngleUnit::Unstated || angle.unit == AngleUnit::Degrees;
      if (angle.isJoined() || !mayBeDegrees || !angle.field->remedy) continue;
      if (!numbersIn(m_rows, at).areMostlyWhole()) continue;
      for (std::size_t i = 0; i < widest(); ++i) {
        if (!mayBeLost(i, at)) continue;
        return refuse(
            i,
            Phrase::of("%1 holds whole degrees and %2 may hold their minutes or seconds: name the columns, "
                       "such as Hz deg, Hz min, Hz sec, or choose what each holds",
                       subjectOf(at), subjectOf(i)));
      }
    }
  }

  /// Refuses a column of signs: the angles would lose their signs.
  void findLostSigns() {
    for (std::size_t i = 0; i < m_plan.columns.size(); ++i) {
      if (m_plan.columns[i].column) continue;
      const auto words = headingWords(m_plan.names[i]);
      const bool isCalledSign = std::ranges::any_of(words, [](const std::string& word) {
        return isOneOf(word, {"sign", "vorzeichen", "vorz", "符", "号", "signo", "signe", "знак"});
      });
      bool areSigns = true, hasMinus = false, hasPlus = false;
      for (const TableCells& row : m_rows) {
        const std::string cell = i < row.size() ? plainSigns(row[i]) : std::string();
        areSigns = areSigns && isOneOf(cell, {"", "+", "-"});
        hasMinus = hasMinus || cell == "-";
        hasPlus = hasPlus || cell == "+";
      }
      if (areSigns && hasMinus && (hasPlus || isCalledSign))
        return refuse(
            i, Phrase::of("%1 contains signs only: put each sign before its degrees", m_plan.nameOf(i)));
    }
  }

  std::size_t widest() const {
    std::size_t width = m_plan.columns.size();
    for (const TableCells& row : m_rows) width = std::max(width, row.size());
    return width;
  }

  /// May a column without a field hold a lost part of the angle? It follows the degrees or is called minutes
  /// or seconds.
  bool mayBeLost(std::size_t column, std::size_t degrees) const {
    const bool isNamed = column < m_plan.columns.size();
    if (isNamed && m_plan.columns[column].column) return false;
    const bool isPart = isNamed && m_plan.columns[column].isUnderstood && m_plan.columns[column].isPart &&
                        m_plan.columns[column].part != AnglePart::Degrees;
    const ColumnNumbers numbers = numbersIn(m_rows, column);
    if (!numbers.areMostlyWithin(0, minutesInDegree)) return false;
    const bool hasHeading = isNamed && !m_plan.names[column].empty();
    return isPart || (column == degrees + 1 && (numbers.areWhole || !hasHeading));
  }

  /// Resolves `grad`, degrees in German and gon in French, by the option or by a reading above 360.
  void takeGrad() {
    constexpr double turn = 360;
    bool isGon = false;
    for (const PlannedAngle& angle : m_plan.angles)
      if (angle.field->remedy) isGon = isGon || !numbersIn(m_rows, angle.at[0]).areAtMost(turn);
    for (PlannedAngle& angle : m_plan.angles) {
      const bool isGrad = m_plan.columns[angle.at[0]].isGrad && angle.unit == AngleUnit::Unstated;
      if (!isGrad || m_layout.unit != AngleUnit::Unstated) continue;
      if (angle.isJoined())
        angle.unit = AngleUnit::Degrees;
      else if (isGon)
        angle.unit = AngleUnit::Gon;
      else if (!numbersIn(m_rows, angle.at[0]).values.empty())
        refuse(
            angle.at[0],
            Phrase::of("%1 names the unit grad, which may be degrees or gon: name it deg or gon, or choose "
                       "the unit (--unit deg, --unit gon)",
                       m_plan.nameOf(angle.at[0])));
    }
  }

  const TableLayout& m_layout;
  TableHeadings m_headings;
  std::vector<TableCells> m_rows;  ///< rows of readings
  TablePlan m_plan;
};

}  // namespace

std::string TablePlan::nameOf(std::size_t column) const {
  const bool isNamed = column < names.size() && !names[column].empty();
  return isNamed ? quotation(names[column]) : std::to_string(column + 1);
}

TablePlan planTable(const std::vector<TableCells>& head, const std::vector<TableCells>& sample,
                    const TableLayout& layout) {
  return TablePlanner(head, sample, layout).plan();
}

}  // namespace alidade
