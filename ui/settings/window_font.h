#pragma once

#include <QFont>
#include <QObject>
#include <QString>
#include <functional>

class QWidget;

namespace alidade::ui {

/// The letters of the window. The report has its own, the same on every machine.
struct FontChoice {
  QString family = {};  ///< empty: the desktop's
  double points = 0;    ///< 0: the desktop's size

  bool operator==(const FontChoice&) const = default;
};

inline constexpr double smallestPoints = 6, largestPoints = 24;

/// What a choice comes to on this desktop.
QFont fontOf(const FontChoice& choice);
/// The same letters, one point larger or smaller, within the limits.
FontChoice resized(const FontChoice& choice, int bySteps);

/// Gives the whole program this font at once, and remembers the choice.
void applyFont(const FontChoice& choice);
FontChoice rememberedFont();

/// Tells that the program has another font; the widgets may have yet to take it.
class FontNews : public QObject {
  Q_OBJECT

 public:
  static FontNews& of();

 signals:
  void changed();
};

/// Does `layOut` now, and anew whenever the program has another font: for sizes that no layout keeps.
void layOutByFont(QWidget& widget, const std::function<void()>& layOut);
/// Letters of this size in proportion to the program's, whatever these become.
void scaleFont(QWidget& widget, double factor);
/// How many pixels now do what `pixels` do with the letters that the window was laid out for.
int byFont(int pixels);

}  // namespace alidade::ui
