#include "ui/charts/plotting/wrapped_lines.h"

#include <QFontMetricsF>
#include <QTextLayout>

namespace alidade::ui {

QStringList wrappedLines(const QString& text, const QFont& font, double width, int most) {
  const QFontMetricsF metrics(font);
  const auto shortened = [&](const QString& part) { return metrics.elidedText(part, Qt::ElideRight, width); };
  if (most < 2 || metrics.horizontalAdvance(text) <= width) return {shortened(text)};
  QStringList lines;
  qsizetype end = 0;
  QTextLayout layout(text, font);
  layout.beginLayout();
  while (end < text.size() && lines.size() + 1 < most) {
    QTextLine line = layout.createLine();
    line.setLineWidth(width);
    end = line.textStart() + line.textLength();
    lines.append(shortened(text.mid(line.textStart(), line.textLength()).trimmed()));
  }
  layout.endLayout();
  if (end < text.size()) lines.append(shortened(text.mid(end)));
  return lines;
}

}  // namespace alidade::ui
