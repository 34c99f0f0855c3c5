#include "ui/panels/parts/dialog_parts.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "ui/language/languages.h"

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

QComboBox* createLanguageChoice(const QString& other, const QString& chosen) {
  auto* choice = new QComboBox;
  choice->setObjectName(QStringLiteral("language"));
  choice->addItem(other, QString());
  for (const LanguageInfo& language : allLanguages()) choice->addItem(language.name, language.id);
  choice->setCurrentIndex(std::max(0, choice->findData(chosen)));
  return choice;
}

}  // namespace alidade::ui
