#include "ui/panels/parts/plain_label.h"

#include <QLabel>

namespace alidade::ui {

QLabel* createPlainLabel(const QString& text) {
  auto* label = new QLabel(text);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

}  // namespace alidade::ui
