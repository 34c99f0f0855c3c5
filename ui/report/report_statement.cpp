#include "ui/report/report_sheet.h"

#include <algorithm>
#include <numeric>

#include "ui/report/report_table.h"
#include "ui/report/report_text.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

using Role = Statement::Column::Role;

bool isLeft(Role role) {
  return role != Role::Figure;
}

/// The indent in mm that keeps left-aligned text apart from a right-aligned figure before the text.
double indentOf(Role role) {
  return isLeft(role) && role != Role::Name ? 2.5 : 0;
}

QString cellText(const Statement::Row& row, std::size_t column) {
  const QString text = qText(row.cells[column]);
  return column == 0 && row.isPart ? QStringLiteral("    ") + text : text;
}

/// The width in mm that a column needs for its cells and its whole title, or the title's longest word.
double neededWidth(const ReportSheet& sheet, const Statement& statement, std::size_t column,
                   bool isTitleWhole) {
  constexpr double gap = 2;
  const QString title = qText(statement.columns[column].title);
  double width = isTitleWhole ? sheet.textWidth(title, type::tableHead) : 0;
  for (const QString& word : title.split(u' '))
    width = std::max(width, sheet.textWidth(word, type::tableHead));
  for (const Statement::Row& row : statement.rows)
    width = std::max(width, sheet.textWidth(cellText(row, column),
                                            row.isTotal || row.isNotable ? type::body.inBold() : type::body));
  return width + gap + indentOf(statement.columns[column].role);
}

/// The width of each column, with titles on one line if the page is wide enough.
std::vector<double> neededWidths(const ReportSheet& sheet, const Statement& statement) {
  std::vector<double> widths;
  for (const bool isTitleWhole : {true, false}) {
    widths.clear();
    for (std::size_t i = 0; i < statement.columns.size(); ++i)
      widths.push_back(neededWidth(sheet, statement, i, isTitleWhole));
    if (std::accumulate(widths.begin(), widths.end(), 0.0) <= ReportSheet::width) break;
  }
  return widths;
}

/// Figures and words get the width they need. Names get 62 mm; in a table with a bar or many columns, at most
/// 62 mm. A remark or bar gets the rest; without remark and bar, the first name may get more. Texts get no
/// width, since they are below the rows. The widest columns of names and words are narrowed until all fit.
std::vector<double> widthsOf(const ReportSheet& sheet, const Statement& statement) {
  constexpr double mostName = 62, leastFigure = 20, fewColumns = 6, mostRemark = 40, leastText = 12;
  const bool hasBar =
      std::ranges::find(statement.columns, Role::Bar, &Statement::Column::role) != statement.columns.end();
  const bool isNarrow = statement.columns.size() > fewColumns || hasBar;
  const std::vector<double> needed = neededWidths(sheet, statement);
  std::vector<double> widths;
  double rest = ReportSheet::width, wideNeeded = 0;
  std::size_t wide = 0;
  for (std::size_t i = 0; i < statement.columns.size(); ++i) {
    const Role role = statement.columns[i].role;
    const bool takesRest = role == Role::Remark || role == Role::Bar;
    double width = needed[i];
    if (role == Role::Figure && statement.columns.size() <= fewColumns) width = std::max(width, leastFigure);
    if (role == Role::Name) width = isNarrow ? std::min(width, mostName) : mostName;
    if (takesRest) {
      wide = i;
      wideNeeded = std::min(width, mostRemark);
    }
    widths.push_back(takesRest || role == Role::Text ? 0 : width);
    rest -= widths.back();
  }
  for (double cut = ReportSheet::width; rest < wideNeeded && cut > leastText; --cut)
    for (std::size_t i = 0; i < widths.size(); ++i)
      if (isLeft(statement.columns[i].role) && widths[i] > cut) {
        rest += widths[i] - cut;
        widths[i] = cut;
      }
  const double lacking = needed[0] - widths[0];
  widths[wide] += wide > 0 ? rest : std::min(std::max(rest, 0.0), std::max(lacking, 0.0));
  return widths;
}

std::vector<ReportColumn> columnsOf(const ReportSheet& sheet, const Statement& statement) {
  const std::vector<double> widths = widthsOf(sheet, statement);
  std::vector<ReportColumn> columns;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const Role role = statement.columns[i].role;
    if (role == Role::Text) continue;
    columns.push_back({qText(statement.columns[i].title), widths[i],
                       isLeft(role) ? Qt::AlignLeft : Qt::AlignRight, indentOf(role)});
  }
  // An empty last column fills the width, so that texts below the rows can use it.
  double rest = ReportSheet::width;
  for (const ReportColumn& column : columns) rest -= column.width;
  if (rest > 0) columns.push_back({QString(), rest});
  return columns;
}

void addTable(ReportSheet& sheet, const Statement& statement) {
  ReportTable table(sheet, columnsOf(sheet, statement));
  table.head();
  for (const Statement::Row& row : statement.rows) {
    std::vector<ReportCell> cells;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (statement.columns[i].role == Role::Text) continue;
      cells.emplace_back(cellText(row, i), row.isTotal || row.isNotable ? type::body.inBold() : type::body);
    }
    QStringList below;
    for (const std::string& text : statement.textsBelow(row)) below.append(qText(text));
    table.row(cells, below.join(u'\n'));
  }
  table.finish();
}

}  // namespace

void addStatement(ReportSheet& sheet, const Statement& statement) {
  if (statement.rows.empty() && statement.sentences.empty()) return;
  constexpr double rowHeight = 4.5;  // mm, about
  sheet.keepTogether(static_cast<double>(statement.rows.size() + 3) * rowHeight);
  sheet.heading(qText(statement.title));
  if (!statement.rows.empty()) addTable(sheet, statement);
  QStringList sentences;
  for (const std::string& sentence : statement.sentences) sentences.append(qText(sentence));
  if (!statement.note.empty()) sentences.append(qText(statement.note));
  if (!sentences.isEmpty()) sheet.paragraph(Report::sentences(sentences), type::small);
}

}  // namespace alidade::ui
