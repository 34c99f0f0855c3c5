#include "ui/report/report_sheet.h"

#include <QFontMetricsF>
#include <QPageLayout>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QTextLayout>
#include <algorithm>

#include "ui/report/report_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

constexpr double headerTop = -9;  // mm above the text area
constexpr double footerGap = 3;   // mm below the text area

/// Number of characters laid out at once, about twenty lines.
constexpr qsizetype longestPiece = 2000;

/// The number of lines kept together at the start of a paragraph of `count` lines.
qsizetype startOf(qsizetype count) {
  return count <= 3 ? count : 2;
}

}  // namespace

ReportSheet::ReportSheet(QPagedPaintDevice& device, ReportFrame frame, const QMarginsF& margins)
    : m_device(device), m_frame(std::move(frame)) {
  const QPageLayout layout = device.pageLayout();
  const QSizeF upright = layout.pageSize().size(QPageSize::Millimeter);
  const QSizeF paper = layout.orientation() == QPageLayout::Portrait ? upright : upright.transposed();
  const double available = paper.width() - margins.left() - margins.right();
  const double deviceUnit = device.logicalDpiX() / 25.4;
  m_scale = std::min(1.0, available / width);
  m_unit = deviceUnit * m_scale;
  m_height = (paper.height() - margins.top() - margins.bottom()) / m_scale;
  m_origin = QPointF(margins.left() + (available - width * m_scale) / 2, margins.top()) * deviceUnit;
}

void ReportSheet::newPage() {
  m_pages.add(m_y);
  m_y = 0;
}

QFont ReportSheet::fontOf(const TextStyle& style) const {
  QFont font = style.font();
  font.setPointSizeF(style.points * m_scale);
  return font;
}

void ReportSheet::keepTogether(double needed) {
  if (room() < needed && m_y > 0) newPage();
}

QStringList ReportSheet::lines(const QString& text, const TextStyle& style, double available) const {
  QStringList result;
  for (const QString& written : visibleLines(text).replace(u'\t', u' ').split(u'\n')) {
    const QString part = visibleLine(written);
    if (part.size() <= longestPiece && textWidth(part, style) <= available)
      result.append(part);
    else
      breakInto(result, part, style, available);
  }
  return result;
}

/// Works piece by piece, since layout time grows with the square of the text's length. The last line of a
/// piece may change with the following text. The next piece therefore begins with that line.
void ReportSheet::breakInto(QStringList& lines, const QString& text, const TextStyle& style,
                            double available) const {
  const QString kept = unbroken(text);
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  for (qsizetype begin = 0; begin < text.size();) {
    const QString piece = kept.mid(begin, longestPiece);
    const bool isLast = begin + piece.size() == text.size();
    QTextLayout layout(piece, fontOf(style), &m_device);
    layout.setTextOption(option);
    layout.beginLayout();
    qsizetype end = 0;
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
      line.setLineWidth(available * m_unit);
      const bool isWhole = isLast || end == 0 || line.textStart() + line.textLength() < piece.size();
      if (!isWhole) break;
      lines.append(text.mid(begin + line.textStart(), line.textLength()).trimmed());
      end = line.textStart() + line.textLength();
    }
    layout.endLayout();
    if (end == 0) return;
    begin += end;
  }
}

double ReportSheet::lineHeight(const TextStyle& style) const {
  return QFontMetricsF(fontOf(style), &m_device).height() * 1.12 / m_unit;
}

double ReportSheet::textWidth(const QString& text, const TextStyle& style) const {
  return QFontMetricsF(fontOf(style), &m_device).horizontalAdvance(text) / m_unit;
}

QString ReportSheet::elided(const QString& text, const TextStyle& style, double available,
                            Qt::TextElideMode mode) const {
  return QFontMetricsF(fontOf(style), &m_device).elidedText(visibleLine(text), mode, available * m_unit);
}

void ReportSheet::draw(Drawing drawing) {
  m_pages.draw(std::move(drawing));
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
  const QFont font = fontOf(style);
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
  keepTogether(20);  // no heading is alone at the foot of a page
  if (m_y > 0) skip(ReportPages::sectionGap);
  m_pages.mayBreak(m_y, ReportPages::Before::Section);
  this->text(text, type::heading, 0, m_y, width);
  skip(lineHeight(type::heading) + 0.8);
}

void ReportSheet::keepStart(const QString& text, const TextStyle& style, double indent) {
  keepTogether(static_cast<double>(startOf(lines(text, style, width - indent).size())) * lineHeight(style));
}

void ReportSheet::paragraph(const QString& text, const TextStyle& style, double indent) {
  const double advance = lineHeight(style);
  const QStringList broken = lines(text, style, width - indent);
  const qsizetype count = broken.size();
  for (qsizetype i = 0; i < count; ++i) {
    const qsizetype kept = i == 0 ? startOf(count) : i == count - 2 ? 2 : 1;
    keepTogether(static_cast<double>(kept) * advance);
    if (i >= 2 && count - i >= 2) mayBreak();
    this->text(broken[i], style, indent, m_y, width - indent);
    skip(advance);
  }
}

bool ReportSheet::paint(QPainter& painter) {
  for (int page = 0; page < pageCount(); ++page) {
    if (m_watch && !m_watch(0.5 + 0.5 * page / pageCount())) return false;
    if (page > 0) m_device.newPage();
    painter.save();
    painter.translate(m_origin);
    paintFrame(painter, page);
    for (const auto& [drawing, lower] : m_pages.drawings(static_cast<std::size_t>(page))) {
      painter.save();
      painter.translate(0, lower * m_unit);
      drawing(painter);
      painter.restore();
    }
    painter.restore();
  }
  return true;
}

void ReportSheet::paintFrame(QPainter& painter, int page) {
  const auto rule = [&](double y) {
    painter.setPen(QPen(Qt::black, 0.15 * m_unit));
    painter.drawLine(QPointF(0, y) * m_unit, QPointF(width, y) * m_unit);
  };
  const double step = lineHeight(type::small);
  const QString session = elided(m_frame.session, type::small, width * 0.44);
  const double left = width * 0.97 - textWidth(session, type::small);
  paintLine(painter, elided(m_frame.product, type::small, left), type::small, 0, headerTop, width,
            Qt::AlignLeft);
  paintLine(painter, session, type::small, 0, headerTop, width, Qt::AlignRight);
  rule(headerTop + step + 0.6);
  const double footerTop = m_height + footerGap;
  rule(footerTop);
  const double first = footerTop + 1;
  paintLine(painter, elided(m_frame.fileName, type::small, width * 0.68, Qt::ElideMiddle), type::small, 0,
            first, width, Qt::AlignLeft);
  const QString pages = Report::tr("page %1 of %2").arg(page + 1).arg(pageCount());
  paintLine(painter, m_frame.date + QStringLiteral("   ") + pages, type::small, 0, first, width,
            Qt::AlignRight);
  paintLine(painter, m_frame.fingerprint, type::fine, 0, first + step, width, Qt::AlignLeft);
  if (page + 1 == pageCount())
    paintLine(painter, Report::tr("End of the report"), type::small, 0, first + step, width, Qt::AlignRight);
}

bool paintSheets(QPagedPaintDevice& device, const ReportFrame& frame, const QMarginsF& margins,
                 const std::function<void(ReportSheet&)>& layOut) {
  ReportSheet sheet(device, frame, margins);
  layOut(sheet);
  QPainter painter;
  if (!painter.begin(&device)) return false;
  const bool isWhole = sheet.paint(painter);
  return painter.end() && isWhole;
}

}  // namespace alidade::ui
