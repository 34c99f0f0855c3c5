#include "ui/charts/plotting/caption.h"

#include <QEvent>
#include <QFontInfo>
#include <algorithm>

namespace alidade::ui {

Caption::Caption(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setForegroundRole(QPalette::PlaceholderText);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  setContentsMargins(6, 0, 6, 2);
  QFont small = font();
  small.setPixelSize(std::max(9, QFontInfo(small).pixelSize() * 9 / 10));
  setFont(small);
}

void Caption::setSentence(const QString& sentence) {
  if (sentence == m_sentence) return;
  m_sentence = sentence;
  setAccessibleName(sentence);
  setToolTip(sentence);
  fit();
}

void Caption::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  fit();
}

void Caption::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

void Caption::fit() {
  setText(fontMetrics().elidedText(m_sentence, Qt::ElideRight, contentsRect().width()));
}

}  // namespace alidade::ui
