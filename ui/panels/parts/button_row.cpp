#include "ui/panels/parts/button_row.h"

#include <QHBoxLayout>
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

}  // namespace alidade::ui
