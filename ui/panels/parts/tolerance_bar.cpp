#include "ui/panels/parts/tolerance_bar.h"

#include <QFontInfo>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/wording/verdict.h"
#include "ui/charts/plotting/tolerance_picture.h"
#include "ui/settings/theme.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

ToleranceBar::ToleranceBar(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Result on the scale of the tolerance"));
  hide();
}

void ToleranceBar::setScale(const std::optional<ToleranceScale>& scale, bool isQuiet) {
  m_scale = scale;
  m_isQuiet = isQuiet;
  setVisible(scale.has_value());
  if (!scale) return;
  const auto [low, high] = endsAsWritten(scale->size, scale->expanded, scale->decimals);
  const auto length = [&](double millimetres) { return lengthText(millimetres, scale->decimals); };
  const QString text = tr("%1, from %2 to %3 with its uncertainty; the limit is %4.")
                           .arg(length(scale->size), length(std::max(low, 0.0)), length(high),
                                plainNumberText(scale->tolerance) + QStringLiteral(" mm"));
  setToolTip(text);
  setAccessibleDescription(text);
  update();
}

QSize ToleranceBar::sizeHint() const {
  const QFont font = pixelFont();
  return {20 * font.pixelSize(), static_cast<int>(std::ceil(heightOfToleranceScale(font)))};
}

QSize ToleranceBar::minimumSizeHint() const {
  return {10 * pixelFont().pixelSize(), sizeHint().height()};
}

void ToleranceBar::paintEvent(QPaintEvent*) {
  if (!m_scale) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor text = m_isQuiet ? stateColor(palette(), State::Quiet) : palette().color(QPalette::WindowText);
  QColor size = text;
  size.setAlphaF(0.45F);
  paintToleranceScale(painter, rect(), *m_scale,
                      {.text = text,
                       .frame = palette().color(QPalette::Mid),
                       .size = size,
                       .within = stateTint(palette(), State::Good),
                       .beyond = stateTint(palette(), State::Bad),
                       .font = pixelFont()});
}

QFont ToleranceBar::pixelFont() const {
  QFont small = font();
  small.setPixelSize(QFontInfo(font()).pixelSize());
  return small;
}

}  // namespace alidade::ui
