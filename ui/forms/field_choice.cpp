#include "ui/forms/field_choice.h"

#include <QKeyEvent>
#include <QWheelEvent>

#include "ui/forms/field_binding.h"
#include "ui/models/next_entry.h"
#include "ui/settings/theme.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int longestEntry = 40;

}  // namespace

FieldChoice::FieldChoice(SessionDocument& document, const Place& place, const QVector<Choice>& choices,
                         QWidget* parent)
    : QComboBox(parent),
      m_binding(new FieldBinding(document, place, this)),
      m_choices(static_cast<int>(choices.size())) {
  for (const Choice& choice : choices) addItem(choice.caption, choice.text);
  setFocusPolicy(Qt::StrongFocus);
  connect(m_binding, &FieldBinding::refreshed, this, &FieldChoice::refresh);
  connect(this, &QComboBox::activated, this, [this](int row) { m_binding->enter(itemData(row).toString()); });
  refresh();
}

void FieldChoice::setHint(const QString& hint) {
  m_hint = hint;
  refresh();
}

void FieldChoice::refresh() {
  const QString text = m_binding->text();
  while (count() > m_choices) removeItem(m_choices);
  int row = text.isEmpty() ? 0 : findData(text);
  if (row < 0) {
    addItem(themeIcon(QStringLiteral("problem")), shortLine(text, longestEntry), text);
    row = m_choices;
  }
  setCurrentIndex(row);
  const QString problem = m_binding->problem();
  setToolTip(problem.isEmpty() ? m_hint : problem);
  setAccessibleDescription(toolTip());
}

void FieldChoice::keyPressEvent(QKeyEvent* event) {
  const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  QWidget* next = isReturn ? nextEntry(this) : nullptr;
  if (next)
    next->setFocus(Qt::TabFocusReason);
  else
    QComboBox::keyPressEvent(event);
}

void FieldChoice::wheelEvent(QWheelEvent* event) {
  event->ignore();
}

}  // namespace alidade::ui
