#include "ui/charts/arc/centres_inset.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/round_numbers.h"
#include "ui/charts/plotting/clipping.h"
#include "ui/charts/plotting/wrapped_lines.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

struct InsetText {
  Q_DECLARE_TR_FUNCTIONS(InsetText)
};

PlanePoint<double> middle(const DrawnIntersection& i) {
  return {(i.upperCentre.x + i.lowerCentre.x) / 2, (i.upperCentre.y + i.lowerCentre.y) / 2};
}

const QString upperName = QStringLiteral("O1"), lowerName = QStringLiteral("O2");

/// The largest half width or height that is shown for the ellipses and U, in units of half the distance of
/// the centres.
constexpr double largestShare = 4;

/// The least height of the centres below a warning, in lines of text.
constexpr double leastPicture = 3;

/// Whether the lines contain the whole text, whose blanks may have become line ends.
bool isWhole(const QStringList& lines, const QString& text) {
  return lines.join(QString()).remove(u' ') == QString(text).remove(u' ');
}

/// Draws the part of a line inside the frame.
void drawWithin(QPainter* painter, const QRectF& frame, const QPointF& from, const QPointF& to) {
  if (const auto part = clipped(QLineF(from, to), frame)) painter->drawLine(*part);
}

/// Half the bounding box of the larger ellipse in each direction; 0 if no ellipse is wide enough.
PlanePoint<double> ellipsesReach(const DrawnIntersection& i) {
  const PlanePoint<double> a = i.upperEllipse.reach(), b = i.lowerEllipse.reach();
  const double x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return std::isfinite(x) && std::isfinite(y) ? PlanePoint<double>{x, y} : PlanePoint<double>{0, 0};
}

}  // namespace

void CentresInset::setStyle(const PlotStyle& style) {
  m_style = style;
  updateScale();
}

void CentresInset::setHeadline(const Headline& headline) {
  m_headline = headline;
  updateScale();
}

void CentresInset::setIntersection(const std::optional<DrawnIntersection>& intersection) {
  m_intersection = intersection;
  setVisible(intersection.has_value());
  updateScale();
}

void CentresInset::setSquare(const QRectF& square) {
  prepareGeometryChange();
  m_square = square;
  updateScale();
}

void CentresInset::updateScale() {
  m_scale = 0;
  update();
  if (!m_intersection || m_square.isEmpty() || m_style.font.pixelSize() <= 0) return;
  const double line = QFontMetricsF(m_style.font).height();
  layOutTitles();
  m_picture = m_square.adjusted(1.2 * line, titlesHeight() + 0.6 * line, -1.2 * line, -1.9 * line);
  m_isCompact = m_picture.width() < 2 * line || m_picture.height() < 2 * line;
  if (m_isCompact) m_titles.clear();
  if (m_isCompact) m_picture = m_square.adjusted(0.4 * line, 0.4 * line, -0.4 * line, -1.9 * line);
  if (m_picture.width() < 2 * line || m_picture.height() < 1.5 * line) return;
  const DrawnIntersection& i = *m_intersection;
  const double expanded = std::isfinite(i.expanded) ? i.expanded : 0;
  const double apart = std::hypot(i.upperCentre.x - i.lowerCentre.x, 2 * i.value) / 2;
  const PlanePoint<double> reach = ellipsesReach(i);
  // Shows the uncertainties completely, up to a size that keeps the centres apart.
  const double halfWidth =
      std::min(std::abs(i.upperCentre.x - i.lowerCentre.x) / 2 + reach.x, largestShare * apart + 1e-6);
  double halfHeight = std::min(std::abs(i.value) + std::max(expanded, reach.y), largestShare * apart + 1e-6);
  if (i.tolerance && *i.tolerance < largestShare * apart)
    halfHeight = std::max(halfHeight, 1.1 * *i.tolerance);
  m_scale = std::min(m_picture.width() * 0.4 / std::max(halfWidth, 1e-6),
                     m_picture.height() * 0.46 / std::max(halfHeight, 1e-6));
}

QRectF CentresInset::frame() const {
  return {m_square.left(), m_picture.top(), m_square.width(), m_picture.height()};
}

QPointF CentresInset::place(const PlanePoint<double>& point) const {
  const PlanePoint<double> origin = middle(*m_intersection);
  return m_picture.center() + m_scale * QPointF(point.x - origin.x, origin.y - point.y);
}

void CentresInset::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  if (m_scale <= 0) {
    paintBare(painter);
    return;
  }
  painter->setFont(m_style.font);
  painter->setPen(QPen(m_style.frame, 0.8 * m_style.unit()));
  painter->setBrush(m_style.background);
  painter->drawRect(m_square);
  painter->save();
  painter->setClipRect(m_square, Qt::IntersectClip);
  paintTolerance(painter);
  paintAxis(painter);
  // Clips a bar longer than the picture, so that title and scale stay readable.
  painter->setClipRect(frame(), Qt::IntersectClip);
  paintEllipses(painter);
  paintClosure(painter);
  paintDistance(painter);
  painter->restore();
  paintCentres(painter);
  paintScaleBar(painter);
  paintTitle(painter);
}

void CentresInset::paintBare(QPainter* painter) const {
  if (!m_intersection) return;
  const QFontMetricsF metrics(m_style.font);
  drawMarker(painter,
             {.shape = MarkerShape::Plus, .colour = m_style.text, .inside = {}, .size = 8 * m_style.unit()},
             m_square.center());
  painter->setFont(m_style.font);
  painter->drawText(m_square.center() + QPointF(0.6 * metrics.height(), -0.2 * metrics.height()),
                    QStringLiteral("O1, O2"));
}

/// Paints the tolerance band, which fills everything below the titles if its limits are outside the picture.
void CentresInset::paintTolerance(QPainter* painter) const {
  const double tolerance = m_intersection->tolerance.value_or(0) * m_scale;
  if (tolerance <= 0) return;
  const double unit = m_style.unit(), centre = m_picture.center().y();
  const double titles = m_titles.isEmpty() ? unit : titlesHeight() + 4 * unit;
  const QRectF inside = m_square.adjusted(unit, titles, -unit, -unit);
  const double top = std::max(centre - tolerance, inside.top());
  const double bottom = std::min(centre + tolerance, inside.bottom());
  painter->fillRect(QRectF(inside.left(), top, inside.width(), bottom - top), m_style.outerBand);
  if (tolerance <= m_picture.height() / 2) {
    painter->setPen(QPen(m_style.limit, unit, Qt::DotLine));
    for (const double y : {top, bottom})
      painter->drawLine(QPointF(inside.left(), y), QPointF(inside.right(), y));
  }
  const QFontMetricsF metrics(m_style.font);
  const QString name = InsetText::tr("tolerance");
  if (tolerance < 2.2 * metrics.height() || m_square.width() < 2.5 * metrics.horizontalAdvance(name)) return;
  painter->setPen(m_style.mutedText);
  // The name of the band is on the side opposite to the name of O2.
  const bool leftSide = place(m_intersection->lowerCentre).x() >= m_picture.center().x();
  const double margin = 0.4 * metrics.height();
  const double left =
      leftSide ? m_square.left() + margin : m_square.right() - metrics.horizontalAdvance(name) - margin;
  painter->drawText(QPointF(left, std::min(bottom, m_picture.bottom()) - 0.3 * metrics.height()), name);
}

void CentresInset::paintAxis(QPainter* painter) const {
  painter->setPen(QPen(m_style.mutedText, m_style.unit(), Qt::DashDotLine));
  const double y = m_picture.center().y();
  painter->drawLine(QPointF(m_square.left(), y), QPointF(m_square.right(), y));
  const QRectF name = axisNameRect();
  if (name.isEmpty()) return;
  painter->setPen(m_style.mutedText);
  painter->drawText(name.topLeft() + QPointF(0, QFontMetricsF(m_style.font).ascent()), InsetText::tr("axis"));
}

/// Empty if the name of the axis overlaps the name of a centre.
QRectF CentresInset::axisNameRect() const {
  if (m_isCompact || m_scale <= 0) return {};
  const QFontMetricsF metrics(m_style.font);
  const double width = metrics.horizontalAdvance(InsetText::tr("axis"));
  const QRectF rect(m_square.right() - width - 0.4 * metrics.height(),
                    m_picture.center().y() - 0.25 * metrics.height() - metrics.ascent(), width,
                    metrics.height());
  return rect.intersects(upperNameRect()) || rect.intersects(lowerNameRect()) ? QRectF() : rect;
}

void CentresInset::paintEllipses(QPainter* painter) const {
  const auto draw = [&](const PlanePoint<double>& centre, const DrawnEllipse& ellipse, const QPen& pen) {
    const double major = ellipse.major * m_scale, minor = ellipse.minor * m_scale;
    // An ellipse far larger than the picture shows no line, and painting it may take very long.
    if (!std::isfinite(major) || minor > 4 * m_square.width() || major > 1000 * m_square.width()) return;
    const QTransform turned = QTransform::fromTranslate(place(centre).x(), place(centre).y())
                                  .rotate(-ellipse.direction * 180 / M_PI);
    painter->setPen(pen);
    painter->setBrush(Qt::NoBrush);
    const PlanePoint<double> reach = ellipse.reach();
    const QPointF corner(reach.x * m_scale, reach.y * m_scale);
    if (frame().contains(QRectF(place(centre) - corner, place(centre) + corner))) {
      painter->save();
      painter->setTransform(turned, true);
      painter->drawEllipse(QPointF(), major, minor);
      painter->restore();
      return;
    }
    constexpr int steps = 360;
    QList<QPointF> points;
    for (int i = 0; i <= steps; ++i) {
      const double angle = 2 * M_PI * i / steps;
      points.append(turned.map(QPointF(major * std::cos(angle), minor * std::sin(angle))));
    }
    for (const QList<QPointF>& piece : clipped(points, frame())) painter->drawPolyline(piece);
  };
  const double width = 1.1 * m_style.unit();
  draw(m_intersection->upperCentre, m_intersection->upperEllipse, QPen(m_style.upper, width));
  draw(m_intersection->lowerCentre, m_intersection->lowerEllipse, QPen(m_style.lower, width, Qt::DashLine));
}

/// Paints no closure if the marker of O2 covers the closure.
void CentresInset::paintClosure(QPainter* painter) const {
  const QPointF wanted = place(m_intersection->closedCentre()), is = place(m_intersection->lowerCentre);
  const double unit = m_style.unit(), away = is.x() - wanted.x();
  if (std::abs(away) < 10 * unit) return;
  painter->setPen(QPen(m_style.mutedText, unit, Qt::DotLine));
  drawWithin(painter, frame(), wanted, is);
  if (frame().contains(wanted))
    drawMarker(painter,
               {.shape = MarkerShape::Plus, .colour = m_style.mutedText, .inside = {}, .size = 9 * unit},
               wanted);
  const QFontMetricsF metrics(m_style.font);
  const QString name = QStringLiteral("Δx");
  if (std::abs(away) < 2 * metrics.horizontalAdvance(name)) return;
  painter->setPen(m_style.mutedText);
  painter->drawText(
      QPointF((wanted.x() + is.x() - metrics.horizontalAdvance(name)) / 2, is.y() - 0.3 * metrics.height()),
      name);
}

void CentresInset::paintCentres(QPainter* painter) const {
  const double ascent = QFontMetricsF(m_style.font).ascent();
  const auto draw = [&](const PlanePoint<double>& centre, int axisDeg, const QRectF& around,
                        const QString& name) {
    drawMarker(painter, m_style.marker(axisDeg, MarkerShape::Circle), place(centre));
    painter->setPen(m_style.text);
    painter->drawText(around.topLeft() + QPointF(0, ascent), name);
  };
  draw(m_intersection->lowerCentre, 180, lowerNameRect(), lowerName);
  draw(m_intersection->upperCentre, 0, upperNameRect(), upperName);
}

QRectF CentresInset::upperNameRect() const {
  return nameRect(m_intersection->upperCentre, m_intersection->upperEllipse, upperName);
}

QRectF CentresInset::lowerNameRect() const {
  return nameRect(m_intersection->lowerCentre, m_intersection->lowerEllipse, lowerName);
}

/// The name is on the outer side of its centre, since Δx is on the inner side; it avoids small ellipses.
QRectF CentresInset::nameRect(const PlanePoint<double>& centre, const DrawnEllipse& ellipse,
                              const QString& name) const {
  const QFontMetricsF metrics(m_style.font);
  const QPointF at = place(centre);
  const double line = metrics.height(), width = metrics.horizontalAdvance(name);
  const bool leftSide = at.x() < m_picture.center().x();
  const double room = (leftSide ? at.x() - m_square.left() : m_square.right() - at.x()) - width - 0.3 * line;
  const double clear = ellipse.reach().x * m_scale + 0.3 * line;
  const double away = std::max(0.6 * line, clear < std::min(room, 4 * line) ? clear : 0);
  return {at + QPointF(leftSide ? -width - away : away, -0.6 * metrics.ascent()), QSizeF(width, line)};
}

void CentresInset::paintDistance(QPainter* painter) const {
  const double unit = m_style.unit();
  const QPointF centre = place(m_intersection->upperCentre);
  const double axis = m_picture.center().y();
  const double reach = std::isfinite(m_intersection->expanded) ? m_intersection->expanded * m_scale : 0;
  painter->setPen(QPen(m_style.text, 2.4 * unit, Qt::SolidLine, Qt::FlatCap));
  drawWithin(painter, frame(), QPointF(centre.x(), axis), centre);
  // U as an error bar at the end of Δd.
  painter->setPen(QPen(m_style.text, unit));
  drawWithin(painter, frame(), centre - QPointF(0, reach), centre + QPointF(0, reach));
  for (const double end : {-reach, reach}) {
    const QPointF at = centre + QPointF(0, end);
    drawWithin(painter, frame(), at - QPointF(4 * unit, 0), at + QPointF(4 * unit, 0));
  }
}

void CentresInset::paintScaleBar(QPainter* painter) const {
  const QFontMetricsF metrics(m_style.font);
  const double margin = (m_isCompact ? 0.3 : 0.6) * metrics.height(), gap = 0.4 * metrics.height();
  const auto textOf = [](double millimetres) { return plainNumberText(millimetres) + QStringLiteral(" mm"); };
  const auto fits = [&](double millimetres) {
    const double beside = metrics.horizontalAdvance(textOf(millimetres)) + margin + gap;
    return millimetres * m_scale + beside <= m_square.width();
  };
  double length = roundDown125(m_square.width() * 0.4 / m_scale);
  // Shortens the bar if its figure does not fit beside it. A compact bar has its figure above.
  if (const double half = roundDown125(0.9 * length); !m_isCompact && !fits(length) && fits(half))
    length = half;
  const QString text = textOf(length);
  const double y = m_square.bottom() - (m_isCompact ? 0.4 : 0.75) * metrics.height();
  const double left = m_square.left() + margin;
  const double right = left + length * m_scale;
  const double tick = 0.25 * metrics.height();
  painter->setPen(QPen(m_style.text, 1.2 * m_style.unit()));
  painter->drawLine(QPointF(left, y), QPointF(right, y));
  for (const double x : {left, right}) painter->drawLine(QPointF(x, y - tick), QPointF(x, y + tick));
  painter->drawText(m_isCompact ? QPointF(left, y - tick) : QPointF(right + gap, y + metrics.ascent() * 0.4),
                    text);
}

double CentresInset::titlesHeight() const {
  double height = 0;
  for (const TitleLine& title : m_titles) height += title.height;
  return height;
}

double CentresInset::titleRoom() const {
  return m_square.width() - 0.8 * QFontMetricsF(m_style.font).height();
}

/// The text in the largest type that fits, at most `most` pixels; else shortened. All lines are equally high.
CentresInset::TitleLine CentresInset::largeLine(const QString& text, int most) const {
  QFont font = m_style.font;
  font.setBold(true);
  double height = 0;
  for (const double factor : {1.25, 1.1, 1.0}) {
    font.setPixelSize(qRound(factor * m_style.font.pixelSize()));
    height = std::max(height, QFontMetricsF(font).height());
    if (font.pixelSize() > most) continue;
    if (QFontMetricsF(font).horizontalAdvance(text) <= titleRoom()) break;
  }
  return {QFontMetricsF(font).elidedText(text, Qt::ElideRight, titleRoom()), font,
          m_headline.isProvisional ? m_style.mutedText : m_style.text, height};
}

/// The headline in two lines if both fit in large type; otherwise each part of the headline has a line. Empty
/// if a figure does not fit.
QList<CentresInset::TitleLine> CentresInset::headlineLines(bool isMarked) const {
  if (m_headline.name.empty()) return {};
  const auto isLarge = [&](const TitleLine& line) {
    return line.font.pixelSize() > m_style.font.pixelSize();
  };
  Headline shown = m_headline;
  if (shown.isProvisional) shown.verdict = InsetText::tr("Provisional").toStdString();
  if (isMarked) shown.verdict += " ⚠";
  const TitleLine first = largeLine(qText(shown.nameAndFigure())),
                  second = largeLine(qText(shown.verdictAndTolerance()), first.font.pixelSize());
  if (isLarge(first) && isLarge(second)) return {first, second};
  const auto isShortened = [&](const std::string& part) {
    return largeLine(qText(part)).text != qText(part);
  };
  if (isShortened(shown.figure) || isShortened(shown.tolerance)) return {};  // a cut figure misleads
  QList<TitleLine> lines{{qText(shown.name), m_style.font, m_style.mutedText}};
  int most = largest;
  for (const std::string& part : {shown.figure, shown.verdict, shown.tolerance}) {
    if (part.empty()) continue;
    lines.append(largeLine(qText(part), most));
    most = lines.back().font.pixelSize();
  }
  return lines;
}

/// Adds the first warning, on as many lines as it needs and the picture leaves, and the name of the picture
/// in small type. If there is no room for the warning, a sign marks the verdict instead.
void CentresInset::layOutTitles() {
  const double line = QFontMetricsF(m_style.font).height();
  m_titles = headlineLines(false);
  m_cutWarning.clear();
  double left = m_square.height() - titlesHeight() - 2.5 * line;
  const auto warning = std::ranges::find(m_headline.lines, true, &Headline::Line::isWarning);
  if (warning != m_headline.lines.end()) {
    const QString text = qText(warning->text);
    QStringList lines;
    if (left >= 6 * line) {
      lines = wrappedLines(text, m_style.font, titleRoom(), static_cast<int>(left / line - leastPicture));
      for (const QString& part : lines) m_titles.append({part, m_style.font, m_style.text});
      left -= (static_cast<double>(lines.size()) - 1) * line;
    } else {
      m_titles = headlineLines(true);
    }
    if (!isWhole(lines, text)) m_cutWarning = text;
  }
  const QString name = InsetText::tr("Fitted centres, enlarged");
  if (left >= 8 * line && QFontMetricsF(m_style.font).horizontalAdvance(name) <= titleRoom())
    m_titles.append({name, m_style.font, m_style.mutedText});
}

void CentresInset::paintTitle(QPainter* painter) const {
  const double line = QFontMetricsF(m_style.font).height();
  double top = m_square.top() + 0.2 * line;
  for (const TitleLine& title : titleLines()) {
    painter->setFont(title.font);
    painter->setPen(title.colour);
    painter->drawText(QPointF(m_square.left() + 0.4 * line, top + QFontMetricsF(title.font).ascent()),
                      title.text);
    top += title.height;
  }
}

}  // namespace alidade::ui
