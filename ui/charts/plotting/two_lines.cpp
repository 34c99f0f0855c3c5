#include "ui/charts/plotting/two_lines.h"

#include <QFontMetricsF>
#include <QTextLayout>

namespace alidade::ui {

QStringList inTwoLines(const QString& text, const QFont& font, double width, int most) {
  const QFontMetricsF metrics(font);
  const auto shortened = [&](const QString& part) { return metrics.elidedText(part, Qt::ElideRight, width); };
  if (most < 2 || metrics.horizontalAdvance(text) <= width) return {shortened(text)};
  QTextLayout layout(text, font);
  layout.beginLayout();
  QTextLine line = layout.createLine();
  line.setLineWidth(width);
  layout.endLayout();
  const int end = line.textLength();
  const QString first = shortened(text.left(end).trimmed());
  return end < text.size() ? QStringList{first, shortened(text.mid(end))} : QStringList{first};
}

}  // namespace alidade::ui
