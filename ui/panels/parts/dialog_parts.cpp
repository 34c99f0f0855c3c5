#include "ui/panels/parts/dialog_parts.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace alidade::ui {

ButtonRow::ButtonRow() : m_layout(new QHBoxLayout(this)) {
  m_layout->setContentsMargins(0, 6, 0, 0);
}

QPushButton* ButtonRow::add(const QString& text, const char* name) {
  auto* button = new QPushButton(text);
  button->setObjectName(QString::fromLatin1(name));
  button->setAutoDefault(false);
  m_layout->addWidget(button);
  return button;
}

void ButtonRow::addRoom() {
  m_layout->addStretch();
}

void makeSafeButton(QPushButton& button) {
  for (QPushButton* other : button.window()->findChildren<QPushButton*>())
    if (other != &button) other->setAutoDefault(false);
  button.setDefault(true);
  button.setFocus();
}

QLabel* createPlainLabel(const QString& text) {
  auto* label = new QLabel(text);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

}  // namespace alidade::ui
