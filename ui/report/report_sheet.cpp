#include "ui/report/report_sheet.h"

#include <QFontMetricsF>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QRegularExpression>
#include <QTextLayout>

#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

constexpr double margin = 20;
constexpr double headerTop = -9;  // mm above the text area
constexpr double footerTop = 255;

/// The same text of the same length that may not be broken between a number and its sign or unit.
QString keptTogether(QString text) {
  static const QRegularExpression gap(QStringLiteral("(?<=±) (?=\\d)|(?<=\\d) (?=mm|%|°)"));
  return text.replace(gap, QString(QChar::Nbsp));
}

}  // namespace

ReportSheet::ReportSheet(QPagedPaintDevice& device, ReportFrame frame)
    : m_device(device), m_frame(std::move(frame)), m_unit(device.logicalDpiX() / 25.4), m_pages(1) {}

void ReportSheet::newPage() {
  m_pages.emplace_back();
  m_y = 0;
}

void ReportSheet::keepTogether(double needed) {
  if (room() < needed && m_y > 0) newPage();
}

QStringList ReportSheet::lines(const QString& text, const TextStyle& style, double available) const {
  QStringList result;
  for (const QString& written : visibleLines(text).replace(u'\t', u' ').split(u'\n')) {
    const QString part = visibleLine(written);
    if (textWidth(part, style) <= available) {
      result.append(part);
      continue;
    }
    QTextLayout layout(keptTogether(part), style.font(), &m_device);
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
      line.setLineWidth(available * m_unit);
      result.append(part.mid(line.textStart(), line.textLength()).trimmed());
    }
    layout.endLayout();
  }
  return result;
}

double ReportSheet::lineHeight(const TextStyle& style) const {
  return QFontMetricsF(style.font(), &m_device).height() * 1.12 / m_unit;
}

double ReportSheet::textWidth(const QString& text, const TextStyle& style) const {
  return QFontMetricsF(style.font(), &m_device).horizontalAdvance(text) / m_unit;
}

void ReportSheet::draw(Drawing drawing) {
  m_pages.back().push_back(std::move(drawing));
}

QRectF ReportSheet::inDeviceUnits(const QRectF& millimetres) const {
  return QRectF(millimetres.topLeft() * m_unit, millimetres.size() * m_unit);
}

void ReportSheet::text(const QString& line, const TextStyle& style, double left, double top, double available,
                       Qt::Alignment alignment) {
  if (line.isEmpty()) return;
  draw([=, this, shown = visibleLine(line)](QPainter& painter) {
    paintLine(painter, shown, style, left, top, available, alignment);
  });
}

void ReportSheet::paintLine(QPainter& painter, const QString& line, const TextStyle& style, double left,
                            double top, double available, Qt::Alignment alignment) const {
  const QFont font = style.font();
  const QFontMetricsF metrics(font, &m_device);
  const double slack = available * m_unit - metrics.horizontalAdvance(line);
  double x = left * m_unit;
  if (alignment & Qt::AlignRight) x += slack;
  if (alignment & Qt::AlignHCenter) x += slack / 2;
  painter.setFont(font);
  painter.setPen(style.colour);
  painter.drawText(QPointF(x, top * m_unit + metrics.ascent()), line);
}

void ReportSheet::rule(double x1, double y1, double x2, double y2, double thickness, const QColor& colour) {
  draw([=, this](QPainter& painter) {
    painter.setPen(QPen(colour, thickness * m_unit, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(x1, y1) * m_unit, QPointF(x2, y2) * m_unit);
  });
}

void ReportSheet::fill(const QRectF& area, const QColor& colour) {
  draw([=, this](QPainter& painter) { painter.fillRect(inDeviceUnits(area), colour); });
}

void ReportSheet::outline(const QRectF& area, double thickness, const QColor& colour) {
  draw([=, this](QPainter& painter) {
    painter.setPen(QPen(colour, thickness * m_unit, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(inDeviceUnits(area));
  });
}

void ReportSheet::heading(const QString& text) {
  keepTogether(20);  // never alone at the foot of a page
  if (m_y > 0) skip(2.8);
  this->text(text, type::heading, 0, m_y, width);
  skip(lineHeight(type::heading) + 0.8);
}

void ReportSheet::paragraph(const QString& text, const TextStyle& style, double indent) {
  const double advance = lineHeight(style);
  for (const QString& line : lines(text, style, width - indent)) {
    keepTogether(advance);
    this->text(line, style, indent, m_y, width - indent);
    skip(advance);
  }
}

bool ReportSheet::paint(QPainter& painter) {
  for (int page = 0; page < pageCount(); ++page) {
    if (m_watch && !m_watch(0.5 + 0.5 * page / pageCount())) return false;
    if (page > 0) m_device.newPage();
    painter.save();
    painter.translate(margin * m_unit, margin * m_unit);
    paintFrame(painter, page);
    for (const Drawing& drawing : m_pages[page]) {
      painter.save();
      drawing(painter);
      painter.restore();
    }
    painter.restore();
  }
  return true;
}

void ReportSheet::paintFrame(QPainter& painter, int page) {
  const auto elided = [&](const QString& text, double available, Qt::TextElideMode mode) {
    return QFontMetricsF(type::small.font(), &m_device)
        .elidedText(visibleLine(text), mode, available * m_unit);
  };
  const auto rule = [&](double y) {
    painter.setPen(QPen(Qt::black, 0.15 * m_unit));
    painter.drawLine(QPointF(0, y) * m_unit, QPointF(width, y) * m_unit);
  };
  const double step = lineHeight(type::small);
  paintLine(painter, elided(m_frame.product, width * 0.53, Qt::ElideRight), type::small, 0, headerTop, width,
            Qt::AlignLeft);
  paintLine(painter, elided(m_frame.session, width * 0.44, Qt::ElideRight), type::small, 0, headerTop, width,
            Qt::AlignRight);
  rule(headerTop + step + 0.6);
  rule(footerTop);
  const double first = footerTop + 1;
  paintLine(painter, elided(m_frame.fileName, width * 0.68, Qt::ElideMiddle), type::small, 0, first, width,
            Qt::AlignLeft);
  const QString pages = QStringLiteral("page %1 of %2").arg(page + 1).arg(pageCount());
  paintLine(painter, m_frame.date + QStringLiteral("   ") + pages, type::small, 0, first, width,
            Qt::AlignRight);
  paintLine(painter, m_frame.fingerprint, type::fine, 0, first + step, width, Qt::AlignLeft);
}

}  // namespace alidade::ui
