#pragma once

#include <QIcon>
#include <QPalette>

class QApplication;
class QTabWidget;

namespace alidade::ui {

enum class Theme { System, Light, Dark };

/// Sets name, version, style and font of the program, equal on every machine. Call once, after the
/// QApplication.
void setUpApplication(QApplication& application);

/// Applies the theme's palette and remembers the theme. `System`: the desktop's palette at program start.
void applyTheme(Theme theme);
Theme rememberedTheme();

bool isDark(const QPalette& palette);

enum class State { Good, Bad, Open, Quiet };

/// The colour of a state, with a contrast of at least 4.5 on the palette's background. A second sign must
/// always accompany the colour.
QColor stateColor(const QPalette& palette, State state);

/// The opaque colour between `a` and `b`, with the share of `b` from 0 to 1.
QColor mixed(const QColor& a, const QColor& b, double shareOfB);

/// A faint background colour of a state.
QColor stateTint(const QPalette& palette, State state);

/// One of the program's own icons, legible on light and dark.
QIcon themeIcon(const QString& name);

/// Marks a tab as having a problem if `wrong`, else removes the mark.
void markTab(QTabWidget& tabs, int tab, bool wrong);

}  // namespace alidade::ui
