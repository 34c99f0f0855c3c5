#pragma once

#include <QSize>

class QMainWindow;
class QWidget;

namespace alidade::ui {

/// True on a screen of less than 1000 pixels; one of 1920 at scale 2 has 960.
bool isNarrow(const QWidget& window);
bool isLow(const QWidget& window);

/// Most of a large screen, within a comfortable field of view.
QSize firstSize(const QWidget& window);

/// The remembered size and the splitters set by hand, within the screen and its frame.
void restoreLayout(QMainWindow& window);
void saveLayout(const QMainWindow& window);

}  // namespace alidade::ui
