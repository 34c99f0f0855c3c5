#pragma once

#include <QFont>
#include <QObject>
#include <QString>
#include <functional>

class QWidget;

namespace alidade::ui {

/// The font of the window. Reports use another font, the same on every machine.
struct FontChoice {
  QString family = {};  ///< empty: the desktop's
  double points = 0;    ///< 0: the desktop's size

  bool operator==(const FontChoice&) const = default;
};

inline constexpr double smallestPoints = 6, largestPoints = 24;

/// The font of a choice on this desktop.
QFont fontOf(const FontChoice& choice);
/// The font larger by `bySteps` points (negative: smaller), between `smallestPoints` and `largestPoints`.
FontChoice resized(const FontChoice& choice, int bySteps);

/// Applies this font to the whole program at once, and remembers the choice.
void applyFont(const FontChoice& choice);
FontChoice rememberedFont();

/// Signals that the program's font changed; widgets may update later.
class FontNews : public QObject {
  Q_OBJECT

 public:
  static FontNews& of();

 signals:
  void changed();
};

/// Calls `layOut` now and after every font change, to set sizes that no layout sets.
void layOutByFont(QWidget& widget, const std::function<void()>& layOut);
/// Scales the letters of a widget relative to the program's font, also after changes of that font.
void scaleFont(QWidget& widget, double factor);
/// `pixels` for DejaVu Sans at 9.5 points, enlarged in proportion to the line height of a larger font.
int byFont(int pixels);
/// The minimum width of a part of a window: `width`, but at most `percent` of the screen, so that a large
/// font leaves the window within its screen; at least `least`, the width for the usual font.
int withinScreen(const QWidget& part, int width, int least, int percent);

}  // namespace alidade::ui
