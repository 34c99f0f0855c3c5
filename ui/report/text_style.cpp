#include "ui/report/text_style.h"

namespace alidade::ui {

QString reportFontFamily() {
  return QStringLiteral("DejaVu Sans");
}

QFont TextStyle::font() const {
  QFont font(monospaced ? QStringLiteral("DejaVu Sans Mono") : reportFontFamily());
  font.setPointSizeF(points);
  font.setBold(bold);
  font.setStyleStrategy(QFont::PreferNoShaping);  // no ligatures: text copied from the PDF reads as printed
  return font;
}

TextStyle TextStyle::inBold() const {
  TextStyle style = *this;
  style.bold = true;
  return style;
}

TextStyle TextStyle::inColour(const QColor& other) const {
  TextStyle style = *this;
  style.colour = other;
  return style;
}

}  // namespace alidade::ui
