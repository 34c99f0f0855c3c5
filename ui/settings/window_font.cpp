#include "ui/settings/window_font.h"

#include <QApplication>
#include <QFontDatabase>
#include <QFontInfo>
#include <QFontMetrics>
#include <QScreen>
#include <QSettings>
#include <QWidget>
#include <algorithm>
#include <cmath>

namespace alidade::ui {

namespace {

const QString familyKey = QStringLiteral("font/family"), pointsKey = QStringLiteral("font/points");
constexpr double usualHeight = 15;  // height of a line of DejaVu Sans at 9.5 points and 96 dots per inch

double within(double points) {
  return std::clamp(points, smallestPoints, largestPoints);
}

}  // namespace

FontNews& FontNews::of() {
  static FontNews news;
  return news;
}

QFont fontOf(const FontChoice& choice) {
  QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
  if (!choice.family.isEmpty()) font.setFamilies({choice.family});
  if (choice.points > 0) font.setPointSizeF(within(choice.points));
  return font;
}

FontChoice resized(const FontChoice& choice, int bySteps) {
  return {choice.family, within(std::round(QFontInfo(fontOf(choice)).pointSizeF()) + bySteps)};
}

void applyFont(const FontChoice& choice) {
  QApplication::setFont(fontOf(choice));
  QSettings settings;
  settings.setValue(familyKey, choice.family);
  settings.setValue(pointsKey, choice.points);
}

FontChoice rememberedFont() {
  const QSettings settings;
  const double points = settings.value(pointsKey, 0).toDouble();
  return {settings.value(familyKey).toString(), points > 0 ? within(points) : 0};
}

void layOutByFont(QWidget& widget, const std::function<void()>& layOut) {
  layOut();
  QObject::connect(&FontNews::of(), &FontNews::changed, &widget, layOut, Qt::QueuedConnection);
}

void scaleFont(QWidget& widget, double factor) {
  layOutByFont(widget, [&widget, factor] {
    QFont font = widget.font();
    font.setPointSizeF(QFontInfo(QApplication::font()).pointSizeF() * factor);
    widget.setFont(font);
  });
}

int byFont(int pixels) {
  const double height = QFontMetrics(QApplication::font()).height();
  return static_cast<int>(std::lround(pixels * std::max(1.0, height / usualHeight)));
}

int withinScreen(const QWidget& part, int width, int least, int percent) {
  return std::min(width, std::max(least, part.screen()->availableGeometry().width() * percent / 100));
}

}  // namespace alidade::ui
