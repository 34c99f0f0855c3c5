#include "ui/charts/plotting/plot_style.h"

#include <QFontInfo>
#include <algorithm>
#include <cmath>

#include "ui/settings/theme.h"

namespace alidade::ui {
namespace {

// Blue and vermillion from Okabe and Ito's palette for all kinds of colour vision ("Color Universal Design",
// 2008), lightened for dark backgrounds.
constexpr QRgb blue = 0xff0072b2;
constexpr QRgb vermillion = 0xffd55e00;
constexpr QRgb lightBlue = 0xff56b4e9;
constexpr QRgb lightOrange = 0xffffa24d;

PlotStyle styleFor(const QColor& background, const QColor& text, const QFont& font) {
  const bool dark = background.lightnessF() < 0.5;
  PlotStyle style;
  style.background = background;
  style.text = text;
  style.mutedText = mixed(text, background, 0.35);
  style.frame = mixed(text, background, 0.5);
  style.grid = mixed(text, background, dark ? 0.82 : 0.88);
  style.upper = dark ? lightBlue : blue;
  style.lower = dark ? lightOrange : vermillion;
  style.excluded = mixed(text, background, 0.45);
  style.band = mixed(text, background, dark ? 0.72 : 0.82);
  style.outerBand = mixed(text, background, dark ? 0.84 : 0.91);
  style.limit = mixed(text, background, 0.4);
  style.font = font;
  return style;
}

}  // namespace

Marker PlotStyle::marker(int axisDeg, MarkerShape shape, int repeat) const {
  return {.shape = shape,
          .colour = ofAxis(axisDeg),
          .inside = background,
          .filled = axisDeg == 0,
          .size = (repeat > 1 ? 5.5 : 7) * unit(),
          .ringed = repeat > 1};
}

Marker PlotStyle::excludedMarker() const {
  return {.shape = MarkerShape::Cross, .colour = excluded, .inside = background, .size = 6 * unit()};
}

PlotStyle screenStyle(const QPalette& palette, const QFont& font) {
  QFont small = font;
  small.setPixelSize(std::max(9, static_cast<int>(std::lround(QFontInfo(font).pixelSize() * 0.9))));
  return styleFor(palette.color(QPalette::Base), palette.color(QPalette::Text), small);
}

PlotStyle printStyle(const QString& fontFamily) {
  QFont font(fontFamily);
  font.setPixelSize(10);  // 7.5 pt
  font.setStyleStrategy(QFont::PreferNoShaping);
  PlotStyle style = styleFor(Qt::white, Qt::black, font);
  style.mutedText = QColor(0x40, 0x40, 0x40);
  return style;
}

}  // namespace alidade::ui
