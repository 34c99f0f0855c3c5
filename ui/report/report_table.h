#pragma once

#include <QString>
#include <vector>

#include "ui/report/report_sheet.h"

namespace alidade::ui {

struct ReportColumn {
  QString title;      ///< may have several lines
  double width = 20;  ///< mm
  Qt::Alignment alignment = Qt::AlignLeft;
  double indent = 0;  ///< mm before the text, within the width
};

struct ReportCell {
  QString text;
  TextStyle style = type::body;

  ReportCell(QString content = {}, TextStyle look = type::body)
      : text(std::move(content)), style(std::move(look)) {}
};

/// Rows under a head repeated on every page. Cells wrap; a row stays on one page. Number columns are
/// right-aligned with equal decimals, which aligns the decimal points.
class ReportTable {
 public:
  ReportTable(ReportSheet& sheet, std::vector<ReportColumn> columns);

  /// Call once before the first row; new pages repeat the head automatically.
  void head();
  /// `note`, if any, follows in small type across the columns below the row, indented by the width of the
  /// first column, at most 12 mm.
  void row(const std::vector<ReportCell>& cells, const QString& note = {});
  /// Draws a line under the last row and moves the cursor below the line.
  void finish();

 private:
  double rowHeight(const std::vector<ReportCell>& cells, std::vector<QStringList>& lines) const;
  void place(const std::vector<ReportCell>& cells, const std::vector<QStringList>& lines);

  ReportSheet& m_sheet;
  std::vector<ReportColumn> m_columns;
  double m_width = 0;
  ReportPages::SharedHead m_head;
  int m_rows = 0;  ///< number of rows below the head on this page
};

}  // namespace alidade::ui
