#include "ui/report/report_table.h"

#include <algorithm>

namespace alidade::ui {
namespace {

constexpr double cellGap = 1.2;  // mm between the texts of neighbouring columns
constexpr double above = 0.35;   // mm above the text of a row, and below it

double textWidth(const ReportColumn& column) {
  return column.width - column.indent - cellGap;
}

}  // namespace

ReportTable::ReportTable(ReportSheet& sheet, std::vector<ReportColumn> columns)
    : m_sheet(sheet), m_columns(std::move(columns)) {
  for (const ReportColumn& column : m_columns) m_width += column.width;
}

void ReportTable::head() {
  std::vector<ReportCell> cells;
  for (const ReportColumn& column : m_columns) cells.emplace_back(column.title, type::tableHead);
  std::vector<QStringList> lines;
  const double height = rowHeight(cells, lines);
  m_sheet.keepTogether(height + 10);
  m_head = m_sheet.head([&] {
    place(cells, lines);
    m_sheet.skip(height);
    m_sheet.rule(0, m_sheet.y(), m_width, m_sheet.y(), 0.25);
    m_sheet.skip(0.5);
  });
  m_rows = 0;
}

void ReportTable::row(const std::vector<ReportCell>& cells, const QString& note) {
  std::vector<QStringList> lines;
  const double height = rowHeight(cells, lines);
  constexpr double mostIndent = 12;
  const double indent = std::min(m_columns.front().width, mostIndent);
  const QStringList noteLines =
      note.isEmpty() ? QStringList() : m_sheet.lines(note, type::small, m_width - indent);
  const double noteLine = m_sheet.lineHeight(type::small);
  const double whole = height + noteLines.size() * noteLine;
  if (m_sheet.room() < std::min(whole, m_sheet.height() / 2)) {
    m_sheet.newPage();
    head();
    m_sheet.beginsWith(m_head);
  }
  if (m_rows++ >= 2) m_sheet.mayBreak(m_head);
  place(cells, lines);
  m_sheet.skip(height);
  for (const QString& line : noteLines) {
    m_sheet.keepTogether(noteLine);
    m_sheet.text(line, type::small, indent, m_sheet.y() - above, m_width - indent);
    m_sheet.skip(noteLine);
  }
}

void ReportTable::finish() {
  m_sheet.skip(0.3);
  m_sheet.rule(0, m_sheet.y(), m_width, m_sheet.y(), 0.15);
  m_sheet.skip(1.5);
}

double ReportTable::rowHeight(const std::vector<ReportCell>& cells, std::vector<QStringList>& lines) const {
  double height = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    lines.push_back(m_sheet.lines(cells[i].text, cells[i].style, textWidth(m_columns[i])));
    height = std::max(height, lines.back().size() * m_sheet.lineHeight(cells[i].style));
  }
  return height + 2 * above;
}

void ReportTable::place(const std::vector<ReportCell>& cells, const std::vector<QStringList>& lines) {
  double left = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool right = m_columns[i].alignment & Qt::AlignRight;
    double top = m_sheet.y() + above;
    for (const QString& line : lines[i]) {
      m_sheet.text(line, cells[i].style, left + m_columns[i].indent + (right ? cellGap : 0), top,
                   textWidth(m_columns[i]), m_columns[i].alignment);
      top += m_sheet.lineHeight(cells[i].style);
    }
    left += m_columns[i].width;
  }
}

}  // namespace alidade::ui
