#include "ui/panels/journal/change_reason_bar.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "ui/commands/explain_change.h"
#include "ui/document/session_document.h"
#include "ui/text/journal_text.h"

namespace alidade::ui {

namespace {

/// True if the entry states no reason: an exclusion has its note, a proposal or an import has its origin.
bool isReasonMissing(const JournalEntry& entry) {
  namespace why = journal_reasons;
  const std::string_view unexplained[] = {why::retyped, why::cleared,  why::pasted, why::usedAgain,
                                          why::deleted, why::inserted, why::moved};
  return std::ranges::find(unexplained, entry.why) != std::end(unexplained);
}

}  // namespace

ChangeReasonBar::ChangeReasonBar(SessionDocument& document, QWidget* parent)
    : QFrame(parent), m_document(document), m_question(new QLabel), m_reason(new QLineEdit) {
  setObjectName(QStringLiteral("change reason"));
  m_question->setTextFormat(Qt::PlainText);
  m_question->setWordWrap(true);
  m_reason->setAccessibleName(tr("Reason for the change"));
  m_reason->setPlaceholderText(tr("Optional: Ctrl+R, type, Enter"));
  m_reason->installEventFilter(this);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_question, 1);
  layout->addWidget(m_reason, 1);
  hide();
  connect(m_reason, &QLineEdit::textEdited, this, &ChangeReasonBar::noteTyped);
  connect(&document, &SessionDocument::recorded, this, &ChangeReasonBar::ask);
  connect(&document, &SessionDocument::changed, this, [this](const SessionChange& change) {
    const bool isAnother = change.kind == SessionChange::Kind::Everything;
    if (isAnother || m_reason->text().isEmpty()) end();
  });
}

void ChangeReasonBar::ask(std::size_t first) {
  const std::vector<JournalEntry>& journal = m_document.session().journal;
  if (!m_reason->text().isEmpty() ||
      !std::all_of(journal.begin() + static_cast<std::ptrdiff_t>(first), journal.end(), isReasonMissing))
    return;
  m_first = first;
  m_count = journal.size() - first;
  m_question->setText(m_count == 1 ? tr("Why was this entry changed? %1").arg(journalPlace(journal[first]))
                                   : tr("Why were these %1 entries changed?").arg(m_count));
  show();
  emit askingChanged(true);
}

void ChangeReasonBar::noteTyped() {
  const std::string reason = m_reason->text().trimmed().toStdString();
  m_document.halfTyped().set(
      m_reason, {.place = {.reading = m_first, .field = "journal"}, .text = reason, .count = m_count},
      !reason.empty());
}

void ChangeReasonBar::start() {
  if (isHidden()) return;
  m_back = QApplication::focusWidget();
  m_reason->setFocus();
}

void ChangeReasonBar::finish() {
  const std::string reason = m_reason->text().trimmed().toStdString();
  const std::size_t first = m_first, count = m_count;
  if (count == 0 || reason.empty()) return;
  end();
  m_document.push(new ExplainChange(m_document, first, count, reason));
}

void ChangeReasonBar::end() {
  if (m_count == 0) return;
  m_count = 0;
  m_document.halfTyped().clear(m_reason);
  if (m_back && m_reason->hasFocus()) m_back->setFocus(Qt::OtherFocusReason);
  m_reason->clear();
  hide();
  emit askingChanged(false);
}

/// Return, or a move of the focus within the window, states the reason; Escape drops the typed text.
bool ChangeReasonBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape) m_reason->clear();
    if (key != Qt::Key_Escape && key != Qt::Key_Return && key != Qt::Key_Enter)
      return QFrame::eventFilter(watched, event);
    finish();
    end();
    return true;
  }
  if (event->type() == QEvent::FocusOut) {
    const auto reason = static_cast<QFocusEvent*>(event)->reason();
    if (reason != Qt::PopupFocusReason && reason != Qt::ActiveWindowFocusReason) finish();
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace alidade::ui
