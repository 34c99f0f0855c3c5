#pragma once

#include <QSize>

class QMainWindow;
class QWidget;

namespace alidade::ui {

/// True if the screen is less than 1000 pixels wide; a screen of 1920 at scale 2 has 960.
bool isNarrow(const QWidget& window);
bool isLow(const QWidget& window);

/// 75 % of the screen, but at least 1280 × 800 and at most 1800 × 1100 pixels.
QSize firstSize(const QWidget& window);

/// Restores the remembered size, limited to the screen minus the frame, and the splitters set by hand.
void restoreLayout(QMainWindow& window);
void saveLayout(const QMainWindow& window);

}  // namespace alidade::ui
