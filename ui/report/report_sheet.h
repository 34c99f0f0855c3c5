#pragma once

#include <QMarginsF>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <functional>
#include <utility>
#include <vector>

#include "core/statement/statement.h"
#include "ui/report/report_pages.h"
#include "ui/report/text_style.h"

class QPagedPaintDevice;
class QPainter;

namespace alidade::ui {

/// The head and foot of every page.
struct ReportFrame {
  QString product;      ///< top left; shortened if too long
  QString session;      ///< top right; shortened if too long
  QString fileName;     ///< foot, left; shortened if too long
  QString fingerprint;  ///< foot, second line; monospaced
  QString date;         ///< foot, right, before the page number
};

class ReportSheet;

/// Lays out a document and paints it on the device, with `frame` on every page. Returns false if painting
/// failed or was stopped.
bool paintSheets(QPagedPaintDevice& device, const ReportFrame& frame, const QMarginsF& margins,
                 const std::function<void(ReportSheet&)>& layOut);

/// A report laid out from top to bottom, page after page, and painted at the end, when the number of pages is
/// known. Lengths in mm; the origin is the top left corner of the text area. The text area has a fixed width:
/// on narrower paper everything is printed smaller, on wider paper the text area is centred.
class ReportSheet {
 public:
  using Drawing = ReportPages::Drawing;

  /// Uses the full page of the device's paper.
  ReportSheet(QPagedPaintDevice& device, ReportFrame frame, const QMarginsF& margins);

  static constexpr double width = 170;

  double height() const { return m_height; }
  double y() const { return m_y; }
  double room() const { return m_height - m_y; }
  int pageCount() const { return static_cast<int>(m_pages.count()); }

  void newPage();
  /// Allows a page break at the cursor, to be used only against a nearly empty last page.
  void mayBreak(ReportPages::SharedHead head = {}) {
    m_pages.mayBreak(m_y, ReportPages::Before::Text, std::move(head));
  }
  /// Records what `drawHead` draws, to be repeated where a table continues.
  template <typename DrawHead>
  ReportPages::SharedHead head(DrawHead drawHead) {
    const ReportPages::Mark mark = m_pages.mark(m_y);
    drawHead();
    return m_pages.headSince(mark, m_y);
  }
  /// Records that this page begins with the head, already drawn.
  void beginsWith(ReportPages::SharedHead head) { m_pages.beginsWith(std::move(head)); }
  /// Starts a new page if less than `needed` mm are left on this page.
  void keepTogether(double needed);
  /// Starts a new page if the first lines of the paragraph do not fit. To be called before anything is drawn
  /// to the left of the paragraph.
  void keepStart(const QString& text, const TextStyle& style, double indent = 0);
  void skip(double distance) { m_y += distance; }

  /// `text` broken into lines no wider than `available`; longer words are broken at the line end.
  QStringList lines(const QString& text, const TextStyle& style, double available) const;
  double lineHeight(const TextStyle& style) const;
  double textWidth(const QString& text, const TextStyle& style) const;
  /// `text` on one line; an ellipsis shortens a text wider than `available`.
  QString elided(const QString& text, const TextStyle& style, double available,
                 Qt::TextElideMode mode = Qt::ElideRight) const;

  /// Draws one line of text on the current page, its top at `top`; `alignment` is horizontal within left…left
  /// + available.
  void text(const QString& line, const TextStyle& style, double left, double top, double available,
            Qt::Alignment alignment = Qt::AlignLeft);
  void rule(double x1, double y1, double x2, double y2, double thickness = 0.15,
            const QColor& colour = Qt::black);
  void fill(const QRectF& area, const QColor& colour);
  void outline(const QRectF& area, double thickness, const QColor& colour = Qt::black);
  /// Adds a drawing in device units; the painter's origin is the top left corner of the text area.
  void draw(Drawing drawing);
  QRectF inDeviceUnits(const QRectF& millimetres) const;

  /// Draws at the cursor and advances the cursor, over page ends if needed. A paragraph never leaves a single
  /// line at the foot or head of a page.
  void heading(const QString& text);
  void paragraph(const QString& text, const TextStyle& style = type::body, double indent = 0);

  /// Called after all layout: fills at least a fifth of the last page if a break of the page before permits.
  void balance() { m_pages.balance(m_y, m_height / 5, m_height); }
  /// The lower end of the last page, after `balance`.
  double lastEnd() const { return m_pages.lastEnd(); }
  /// Paints all pages. Returns false if `watch` stopped the painting.
  bool paint(QPainter& painter);

  /// `watch` is called often with the share of the work done; returning false stops the work.
  void setWatch(std::function<bool(double done)> watch) { m_watch = std::move(watch); }
  /// To be called during long layout, with the share of the present table done. False: the layout must stop.
  bool goesOn(double laidOut) const { return !m_watch || m_watch(laidOut / 2); }

 private:
  void paintFrame(QPainter& painter, int page);
  void paintLine(QPainter& painter, const QString& line, const TextStyle& style, double left, double top,
                 double available, Qt::Alignment alignment) const;
  QFont fontOf(const TextStyle& style) const;
  void breakInto(QStringList& lines, const QString& text, const TextStyle& style, double available) const;

  QPagedPaintDevice& m_device;
  ReportFrame m_frame;
  double m_scale = 1;  // printed size as a share of the nominal size; below 1 on narrow paper
  double m_unit;       // device units per millimetre in print
  double m_height;
  QPointF m_origin;  // origin of the text area, in device units
  double m_y = 0;
  std::function<bool(double done)> m_watch;
  ReportPages m_pages;
};

/// A section: the title, the table over the whole width with totals in bold, sentences and note. Draws
/// nothing if there are neither rows nor sentences.
void addStatement(ReportSheet& sheet, const Statement& statement);

}  // namespace alidade::ui
