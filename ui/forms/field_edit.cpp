#include "ui/forms/field_edit.h"

#include <QAction>
#include <QKeyEvent>
#include <QPainter>
#include <limits>

#include "ui/forms/field_binding.h"
#include "ui/models/next_entry.h"
#include "ui/settings/theme.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

FieldEdit::FieldEdit(SessionDocument& document, const Place& place, Shows shows, QWidget* parent)
    : QLineEdit(parent), m_binding(new FieldBinding(document, place, this)), m_shows(shows) {
  setMaxLength(std::numeric_limits<int>::max());  // otherwise a long text would be truncated
  m_mark = addAction(themeIcon(QStringLiteral("problem")), QLineEdit::TrailingPosition);
  m_mark->setVisible(false);
  connect(m_binding, &FieldBinding::refreshed, this, &FieldEdit::refresh);
  connect(m_binding, &FieldBinding::commitWanted, this, &FieldEdit::commit);
  connect(this, &QLineEdit::returnPressed, this, &FieldEdit::commit);
  connect(this, &QLineEdit::textEdited, this, [this] { m_binding->noteTyped(entered()); });
  refresh();
}

void FieldEdit::setHint(const QString& hint) {
  m_hint = hint;
  refresh();
}

void FieldEdit::commit() {
  if (!isModified()) return;
  setModified(false);
  m_binding->enter(entered());
  refresh();
}

/// The text that committing would enter.
QString FieldEdit::entered() const {
  const std::string typed = text().trimmed().toStdString();
  return qText(m_shows == Shows::Angle ? completedAngle(typed, m_binding->angleUnit()) : typed);
}

void FieldEdit::refresh() {
  if (isModified()) return;
  const QString typed = m_binding->text();
  const bool asAngle = m_shows == Shows::Angle;
  const QString shown = hasFocus() ? typed
                        : asAngle  ? shownAngle(typed.toStdString(), m_binding->angleUnit())
                                   : visibleLine(typed);
  if (text() != shown) {
    setText(shown);
    setCursorPosition(0);
  }
  m_problem = m_binding->problem();
  m_mark->setVisible(hasProblem());
  m_mark->setToolTip(m_problem);
  setToolTip(hasProblem() ? m_problem : tip(typed));
  setAccessibleDescription(toolTip());
  update();
}

/// The hint; before it the whole text, if the text may not fit the field or has invisible characters.
QString FieldEdit::tip(const QString& typed) const {
  constexpr int usuallyFits = 40;
  if (m_shows == Shows::Angle || (typed.size() <= usuallyFits && visibleLine(typed) == typed)) return m_hint;
  return m_hint.isEmpty() ? tipText(typed) : tipText(typed) + QStringLiteral("\n\n") + m_hint;
}

/// Undo and redo belong to the session unless an entry here is unfinished.
bool FieldEdit::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && !isModified()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return false;
    }
  }
  return QLineEdit::event(event);
}

void FieldEdit::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && isModified()) {
    setModified(false);
    m_binding->noteTypingEnded();
    refresh();
    return;
  }
  QLineEdit::keyPressEvent(event);
  if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter) return;
  if (QWidget* next = nextEntry(this)) next->setFocus(Qt::TabFocusReason);
}

void FieldEdit::focusInEvent(QFocusEvent* event) {
  QLineEdit::focusInEvent(event);
  const bool byKey = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  refresh();
  if (byKey) selectAll();
}

void FieldEdit::focusOutEvent(QFocusEvent* event) {
  commit();
  QLineEdit::focusOutEvent(event);
  refresh();
}

void FieldEdit::paintEvent(QPaintEvent* event) {
  QLineEdit::paintEvent(event);
  if (!hasProblem()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(stateColor(palette(), State::Bad), 2));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 2, 2);
}

}  // namespace alidade::ui
