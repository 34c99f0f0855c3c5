#include "ui/forms/field_notes.h"

#include <QKeyEvent>
#include <QTextDocument>

#include "ui/forms/field_binding.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

FieldNotes::FieldNotes(SessionDocument& document, const Place& place, QWidget* parent)
    : QPlainTextEdit(parent), m_binding(new FieldBinding(document, place, this)) {
  setTabChangesFocus(true);
  connect(m_binding, &FieldBinding::refreshed, this, &FieldNotes::refresh);
  connect(m_binding, &FieldBinding::commitWanted, this, &FieldNotes::commit);
  connect(this, &QPlainTextEdit::textChanged, this, [this] {
    if (this->document()->isModified()) m_binding->noteTyped(typed());
  });
  refresh();
}

void FieldNotes::commit() {
  if (!document()->isModified()) return;
  document()->setModified(false);
  m_binding->enter(typed());
}

void FieldNotes::refresh() {
  if (document()->isModified()) return;
  const QString shown = hasFocus() ? m_binding->text() : visibleLines(m_binding->text());
  if (typed() == shown) return;
  setPlainText(shown);
  document()->setModified(false);
}

/// The text as typed; `toPlainText` would turn every no-break space into a blank.
QString FieldNotes::typed() const {
  return document()->toRawText().replace(QChar::ParagraphSeparator, u'\n');
}

/// Undo and redo belong to the session unless an entry here is unfinished.
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

void FieldNotes::focusInEvent(QFocusEvent* event) {
  QPlainTextEdit::focusInEvent(event);
  refresh();
}

void FieldNotes::focusOutEvent(QFocusEvent* event) {
  commit();
  QPlainTextEdit::focusOutEvent(event);
  refresh();
}

}  // namespace alidade::ui
