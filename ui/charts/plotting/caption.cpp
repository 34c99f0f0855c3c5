#include "ui/charts/plotting/caption.h"

#include <QEvent>
#include <algorithm>

#include "ui/charts/plotting/wrapped_lines.h"
#include "ui/settings/window_font.h"

namespace alidade::ui {

Caption::Caption(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setForegroundRole(QPalette::PlaceholderText);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  setContentsMargins(6, 0, 6, 2);
  scaleFont(*this, 0.9);
}

void Caption::setSentence(const QString& sentence) {
  if (sentence == m_sentence) return;
  m_sentence = sentence;
  setAccessibleName(sentence);
  setToolTip(sentence);
  fit();
}

void Caption::setMaySpread(bool may) {
  if (may == m_maySpread) return;
  m_maySpread = may;
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

int Caption::heightOf(int lines) const {
  const QMargins around = contentsMargins();
  return lines * fontMetrics().lineSpacing() + around.top() + around.bottom();
}

int Caption::room(int width) const {
  const QMargins around = contentsMargins();
  return std::max(0, width - around.left() - around.right());
}

int Caption::heightForWidth(int width) const {
  return heightOf(1 + static_cast<int>(fitted(width).count(u'\n')));
}

QString Caption::fitted(int width) const {
  return wrappedLines(m_sentence, font(), room(width), m_maySpread ? 2 : 1).join(u'\n');
}

void Caption::fit() {
  const QString text = fitted(width());
  if (text == this->text()) return;
  setText(text);
  updateGeometry();
}

}  // namespace alidade::ui
