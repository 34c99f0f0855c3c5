#include "ui/panels/readings/reason_line.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QTableView>
#include <algorithm>
#include <utility>

namespace alidade::ui {

ReasonLine::ReasonLine(QTableView& table) : QLineEdit(table.viewport()), m_table(table) {
  setObjectName(QStringLiteral("reason"));
  setAccessibleName(tr("Reason for the exclusion"));
  hide();
}

void ReasonLine::ask(const std::vector<std::size_t>& rows) {
  finish();
  if (rows.empty() || !m_table.isVisible()) return;
  m_rows = rows;
  setPlaceholderText(rows.size() == 1
                         ? tr("Why is row %1 excluded? (Enter: no reason)").arg(rows.front() + 1)
                         : tr("Why are these %1 rows excluded? (Enter: no reason)").arg(rows.size()));
  place();
  show();
  raise();
  setFocus();
}

/// Places the line below the last row, or above the first one if there is no room below the last.
void ReasonLine::place() {
  const auto lineOf = [this](std::size_t row) {
    return m_table.visualRect(m_table.model()->index(static_cast<int>(row), 0));
  };
  m_table.scrollTo(m_table.model()->index(static_cast<int>(m_rows.back()), m_table.currentIndex().column()));
  const int height = sizeHint().height();
  int top = lineOf(m_rows.back()).bottom() + 1;
  if (top + height > parentWidget()->height()) top = std::max(0, lineOf(m_rows.front()).top() - height);
  setGeometry(0, top, parentWidget()->width(), height);
}

void ReasonLine::finish() {
  if (m_rows.empty()) return;
  const std::vector<std::size_t> rows = std::exchange(m_rows, {});
  const QString reason = text().trimmed();
  if (hasFocus()) m_table.setFocus();  // hiding first would move the focus like Tab
  clear();
  hide();
  emit closed();
  if (!reason.isEmpty()) emit given(rows, reason);
}

void ReasonLine::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Escape) clear();
  if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Escape) return finish();
  const bool isPassing = key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_Space;
  if (!isPassing || !text().isEmpty()) return QLineEdit::keyPressEvent(event);
  finish();
  QCoreApplication::sendEvent(&m_table, event);
}

/// Closes the line when it loses the focus, unless another window or a menu gets the focus.
void ReasonLine::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason) finish();
}

}  // namespace alidade::ui
