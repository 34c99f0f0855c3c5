#include "ui/forms/field_notes.h"

#include <QKeyEvent>
#include <QTextDocument>

#include "ui/forms/field_binding.h"

namespace alidade::ui {

FieldNotes::FieldNotes(SessionDocument& document, const Place& place, QWidget* parent)
    : QPlainTextEdit(parent), m_binding(new FieldBinding(document, place, this)) {
  setTabChangesFocus(true);
  connect(m_binding, &FieldBinding::refreshed, this, &FieldNotes::refresh);
  connect(m_binding, &FieldBinding::commitWanted, this, &FieldNotes::commit);
  refresh();
}

void FieldNotes::commit() {
  if (!document()->isModified()) return;
  document()->setModified(false);
  m_binding->enter(toPlainText());
}

void FieldNotes::refresh() {
  if (document()->isModified() || toPlainText() == m_binding->text()) return;
  setPlainText(m_binding->text());
  document()->setModified(false);
}

/// Undo and redo belong to the session unless something is half typed here.
bool FieldNotes::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && !document()->isModified()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return false;
    }
  }
  return QPlainTextEdit::event(event);
}

void FieldNotes::focusOutEvent(QFocusEvent* event) {
  commit();
  QPlainTextEdit::focusOutEvent(event);
}

}  // namespace alidade::ui
