#pragma once

#include <QMarginsF>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <functional>
#include <utility>
#include <vector>

#include "ui/report/report_pages.h"
#include "ui/report/text_style.h"

class QPagedPaintDevice;
class QPainter;

namespace alidade::ui {

/// What stands at the top and the foot of every page.
struct ReportFrame {
  QString product;      ///< top left; shortened where it is too long
  QString session;      ///< top right; shortened where it is too long
  QString fileName;     ///< foot, left; shortened where it is too long
  QString fingerprint;  ///< foot, second line; monospaced
  QString date;         ///< foot, right, before the page number
};

/// A report laid out from top to bottom, page after page, and painted when all is known: only then is the
/// number of pages. Lengths in mm; the origin is the top left corner of the text area, which is always
/// equally wide: where the paper's margins leave less for it, everything is printed smaller, where they leave
/// more, it stands in the middle.
class ReportSheet {
 public:
  using Drawing = ReportPages::Drawing;

  /// On the device's paper, which is painted on from corner to corner.
  ReportSheet(QPagedPaintDevice& device, ReportFrame frame, const QMarginsF& margins);

  static constexpr double width = 170;

  double height() const { return m_height; }
  double y() const { return m_y; }
  double room() const { return m_height - m_y; }
  int pageCount() const { return static_cast<int>(m_pages.count()); }

  void newPage();
  /// A page may begin here, where that spares the last page from being next to empty.
  void mayBreak(ReportPages::SharedHead head = {}) {
    m_pages.mayBreak(m_y, ReportPages::Before::Text, std::move(head));
  }
  /// What `drawHead` draws, to be drawn again where a table goes on.
  template <typename DrawHead>
  ReportPages::SharedHead head(DrawHead drawHead) {
    const ReportPages::Mark mark = m_pages.mark(m_y);
    drawHead();
    return m_pages.headSince(mark, m_y);
  }
  /// This page begins with it.
  void beginsWith(ReportPages::SharedHead head) { m_pages.beginsWith(std::move(head)); }
  /// Starts a new page where less than `needed` mm are left on this one.
  void keepTogether(double needed);
  void skip(double distance) { m_y += distance; }

  /// `text` broken into lines no wider than `available`; words too long for a line are broken where it ends.
  QStringList lines(const QString& text, const TextStyle& style, double available) const;
  double lineHeight(const TextStyle& style) const;
  double textWidth(const QString& text, const TextStyle& style) const;
  /// One line no wider than `available`, shortened where it is too long.
  QString elided(const QString& text, const TextStyle& style, double available,
                 Qt::TextElideMode mode = Qt::ElideRight) const;

  /// One line of text into the current page, its top at `top`; `alignment` horizontally within left…left +
  /// available.
  void text(const QString& line, const TextStyle& style, double left, double top, double available,
            Qt::Alignment alignment = Qt::AlignLeft);
  void rule(double x1, double y1, double x2, double y2, double thickness = 0.15,
            const QColor& colour = Qt::black);
  void fill(const QRectF& area, const QColor& colour);
  void outline(const QRectF& area, double thickness, const QColor& colour = Qt::black);
  /// Anything else: painted with the page's origin at the text area's corner, in device units.
  void draw(Drawing drawing);
  QRectF inDeviceUnits(const QRectF& millimetres) const;

  /// At the cursor, over page ends where need be, and the cursor moves on. No line of a paragraph stands
  /// alone at the foot or the head of a page.
  void heading(const QString& text);
  void paragraph(const QString& text, const TextStyle& style = type::body, double indent = 0);

  /// All is laid out: what is left over for the last page is no less than a fifth of one, where what stands
  /// before it can be parted so.
  void balance() { m_pages.balance(m_y, m_height / 5, m_height); }
  /// Where the last page ends, once it is balanced.
  double lastEnd() const { return m_pages.lastEnd(); }
  /// Paints all pages. False: it was stopped.
  bool paint(QPainter& painter);

  /// `watch` is asked often, with the share of the work that is done, and ends it by false.
  void setWatch(std::function<bool(double done)> watch) { m_watch = std::move(watch); }
  /// Asked while much is laid out, with the share of that which is done. False: lay out no more.
  bool goesOn(double laidOut) const { return !m_watch || m_watch(laidOut / 2); }

 private:
  void paintFrame(QPainter& painter, int page);
  void paintLine(QPainter& painter, const QString& line, const TextStyle& style, double left, double top,
                 double available, Qt::Alignment alignment) const;
  QFont fontOf(const TextStyle& style) const;
  void breakInto(QStringList& lines, const QString& text, const TextStyle& style, double available) const;

  QPagedPaintDevice& m_device;
  ReportFrame m_frame;
  double m_scale = 1;  // below 1: printed smaller
  double m_unit;       // device units to the millimetre as printed
  double m_height;
  QPointF m_origin;  // of the text area, in device units
  double m_y = 0;
  std::function<bool(double done)> m_watch;
  ReportPages m_pages;
};

}  // namespace alidade::ui
