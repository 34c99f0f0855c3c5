#include "ui/entry/stray_digits.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScopedValueRollback>
#include <QTextEdit>

#include "ui/panels/parts/entry_table.h"

namespace alidade::ui {

namespace {

/// True for a digit typed without modifier keys: it may begin an angle or a length.
bool beginsANumber(const QKeyEvent& event) {
  const auto modifiers = event.modifiers() & ~Qt::KeypadModifier;
  const QString text = event.text();
  return modifiers == Qt::NoModifier && text.size() == 1 && text.front().isDigit();
}

bool takesText(const QWidget* widget) {
  const auto* lines = qobject_cast<const QPlainTextEdit*>(widget);
  const auto* page = qobject_cast<const QTextEdit*>(widget);
  const auto* choice = qobject_cast<const QComboBox*>(widget);
  return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
         qobject_cast<const EntryTable*>(widget) || (lines && !lines->isReadOnly()) ||
         (page && !page->isReadOnly()) || (choice && choice->isEditable());
}

}  // namespace

StrayDigits::StrayDigits(QWidget& window) : QObject(&window), m_window(window) {
  qApp->installEventFilter(this);
}

bool StrayDigits::eventFilter(QObject* watched, QEvent* event) {
  if (m_isForwarding || event->type() != QEvent::KeyPress) return false;
  auto* key = static_cast<QKeyEvent*>(event);
  // Qt sends an ignored event again to each parent of its receiver; those repeats are skipped.
  const QWidget* focus = QApplication::focusWidget();
  const auto* widget = qobject_cast<QWidget*>(watched);
  if (!widget || widget != (focus ? focus : &m_window) || widget->window() != &m_window) return false;
  if (!beginsANumber(*key) || takesText(widget)) return false;
  const QScopedValueRollback forwarding(m_isForwarding, true);  // else the filter catches the forwarded digit
  emit typed(key);
  return true;
}

}  // namespace alidade::ui
