#pragma once

#include <QIcon>
#include <QPalette>

class QApplication;
class QTabWidget;

namespace alidade::ui {

enum class Theme { System, Light, Dark };

/// Name, version, style and font of the program, the same on every machine. Call once, after the
/// QApplication.
void setUpApplication(QApplication& application);

/// Gives the program the theme's palette and remembers it. System follows the desktop's palette as it was at
/// the start.
void applyTheme(Theme theme);
Theme rememberedTheme();

bool isDark(const QPalette& palette);

enum class State { Good, Bad, Open, Quiet };

/// Colours that stand out on the palette's background with a contrast of at least 4.5. Never the only sign of
/// a state.
QColor stateColor(const QPalette& palette, State state);

/// A faint background of the same meaning.
QColor stateTint(const QPalette& palette, State state);

/// One of the program's own icons, legible on light and dark.
QIcon themeIcon(const QString& name);

/// Marks a tab behind which something is wrong; leaves it alone where it is marked so already.
void markTab(QTabWidget& tabs, int tab, bool wrong);

}  // namespace alidade::ui
