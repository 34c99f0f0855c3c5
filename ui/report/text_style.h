#pragma once

#include <QColor>
#include <QFont>

namespace alidade::ui {

/// A style of printed text. All styles use the DejaVu fonts, so that a report looks the same everywhere.
struct TextStyle {
  double points = 8.5;
  bool bold = false;
  bool monospaced = false;
  QColor colour = Qt::black;

  QFont font() const;

  TextStyle inBold() const;
  TextStyle inColour(const QColor& other) const;
};

/// The family of the report's text and of its plots.
QString reportFontFamily();

namespace type {
inline const TextStyle title{.points = 17, .bold = true};
inline const TextStyle subtitle{.points = 11};
inline const TextStyle heading{.points = 10, .bold = true};
inline const TextStyle body{};
inline const TextStyle detail{.points = 8};
inline const TextStyle label{.colour = QColor(0x50, 0x50, 0x50)};
inline const TextStyle tableHead{.points = 7.5, .bold = true, .colour = QColor(0x50, 0x50, 0x50)};
inline const TextStyle small{.points = 7};
inline const TextStyle fine{.points = 6.5, .monospaced = true};
}  // namespace type

}  // namespace alidade::ui
