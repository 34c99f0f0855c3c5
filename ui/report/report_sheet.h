#pragma once

#include <QRectF>
#include <QString>
#include <QStringList>
#include <functional>
#include <utility>
#include <vector>

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

/// An A4 report laid out from top to bottom, page after page, and painted when all is known: only then is the
/// number of pages. Lengths in mm; the origin is the top left corner of the text area, inside margins of 20
/// mm.
class ReportSheet {
 public:
  using Drawing = std::function<void(QPainter&)>;

  ReportSheet(QPagedPaintDevice& device, ReportFrame frame);

  static constexpr double width = 170;
  static constexpr double height = 252;

  double y() const { return m_y; }
  double room() const { return height - m_y; }
  int pageCount() const { return static_cast<int>(m_pages.size()); }

  void newPage();
  /// Starts a new page where less than `needed` mm are left on this one.
  void keepTogether(double needed);
  void skip(double distance) { m_y += distance; }

  /// `text` broken into lines no wider than `available`; words too long for a line are broken where it ends.
  QStringList lines(const QString& text, const TextStyle& style, double available) const;
  double lineHeight(const TextStyle& style) const;
  double textWidth(const QString& text, const TextStyle& style) const;

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

  /// At the cursor, over page ends where need be, and the cursor moves on.
  void heading(const QString& text);
  void paragraph(const QString& text, const TextStyle& style = type::body, double indent = 0);

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

  QPagedPaintDevice& m_device;
  ReportFrame m_frame;
  double m_unit;  // device units to the millimetre
  double m_y = 0;
  std::function<bool(double done)> m_watch;
  std::vector<std::vector<Drawing>> m_pages;
};

}  // namespace alidade::ui
