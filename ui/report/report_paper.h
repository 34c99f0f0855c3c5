#pragma once

#include <QMarginsF>
#include <QPageLayout>
#include <QPageSize>

namespace alidade::ui {

/// The paper of a report: always upright, with the text inside its margins. Head and foot of the page are in
/// the upper and lower margin.
struct ReportPaper {
  QPageSize::PageSizeId size = QPageSize::A4;
  QMarginsF margins{20, 20, 20, 25};  ///< mm

  /// Limits of each margin, in mm: head and foot need room, and so does the text.
  static constexpr double leastMargin = 15, mostMargin = 40;

  bool operator==(const ReportPaper& other) const { return size == other.size && margins == other.margins; }

  /// The layout for the full page, since the report draws its own margins.
  QPageLayout layout() const {
    QPageLayout layout(QPageSize(size), QPageLayout::Portrait, QMarginsF(0, 0, 0, 0));
    layout.setMode(QPageLayout::FullPageMode);
    return layout;
  }
};

}  // namespace alidade::ui
