#include "ui/window/window_layout.h"

#include <QMainWindow>
#include <QScreen>
#include <QSettings>
#include <QSplitter>

#include "ui/panels/parts/frames.h"

namespace alidade::ui {

namespace {

QString layoutKey(const QString& name) {
  return QStringLiteral("window/") + name;
}

}  // namespace

bool isNarrow(const QWidget& window) {
  return window.screen()->availableGeometry().width() < 1000;
}

bool isLow(const QWidget& window) {
  return window.screen()->availableGeometry().height() < 620;
}

QSize firstSize(const QWidget& window) {
  constexpr QSize usual(1280, 800), largest(1800, 1100);
  return (window.screen()->availableGeometry().size() * 0.75).expandedTo(usual).boundedTo(largest);
}

void restoreLayout(QMainWindow& window) {
  const QSettings settings;
  window.restoreGeometry(settings.value(layoutKey(QStringLiteral("geometry"))).toByteArray());
  window.restoreState(settings.value(layoutKey(QStringLiteral("state"))).toByteArray());
  for (QSplitter* splitter : window.findChildren<QSplitter*>())
    if (splitter->restoreState(settings.value(layoutKey(splitter->objectName())).toByteArray()))
      markSetByHand(*splitter);
  constexpr QSize frame(16, 40);
  const QRect room = window.screen()->availableGeometry();
  window.resize(window.size().boundedTo(room.size() - frame));
}

void saveLayout(const QMainWindow& window) {
  QSettings settings;
  settings.setValue(layoutKey(QStringLiteral("geometry")), window.saveGeometry());
  settings.setValue(layoutKey(QStringLiteral("state")), window.saveState());
  for (const QSplitter* splitter : window.findChildren<QSplitter*>())
    if (isSetByHand(*splitter)) settings.setValue(layoutKey(splitter->objectName()), splitter->saveState());
}

}  // namespace alidade::ui
