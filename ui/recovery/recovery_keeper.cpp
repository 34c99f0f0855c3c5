#include "ui/recovery/recovery_keeper.h"

#include <QFile>
#include <QUuid>
#include <utility>

#include "core/base/atomic_file.h"
#include "ui/document/encoded_path.h"
#include "ui/document/session_document.h"
#include "ui/recovery/half_typed_record.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

std::optional<Problem> writePrivately(const QString& path, const std::string& text) {
  return writeFiles({{.path = encodedPath(path), .bytes = text, .isPrivate = true}}, {});
}

}  // namespace

RecoveryKeeper::RecoveryKeeper(SessionDocument& document, const QString& folder, QObject* parent)
    : QObject(parent), m_document(document), m_slot(RecoverySlot::create(folder)) {
  constexpr int delayMs = 250;
  m_timer.setSingleShot(true);
  m_timer.setInterval(delayMs);
  startWriter();
  connect(&m_timer, &QTimer::timeout, this, &RecoveryKeeper::keep);
  connect(&document, &SessionDocument::changed, this, &RecoveryKeeper::noteChange);
  connect(&document, &SessionDocument::identityChanged, this, &RecoveryKeeper::noteChange);
  connect(&document.halfTyped(), &HalfTyped::changed, this, &RecoveryKeeper::schedule);
}

void RecoveryKeeper::startWriter() {
  m_writing = std::make_unique<Background<Written>>(
      [this](const std::shared_ptr<const Written>& problem) { finishWriting(*problem); });
}

void RecoveryKeeper::adopt(std::unique_ptr<RecoverySlot> slot) {
  std::swap(m_slot, slot);
  slot->remove();
  noteChange();
}

void RecoveryKeeper::keepNow() {
  m_timer.stop();
  m_writing.reset();  // waits for the running write
  startWriter();
  m_isDue = false;
  m_isSessionDue = true;
  if (isNeeded()) finishWriting(write(takeDue()));
}

void RecoveryKeeper::finish() {
  m_document.disconnect(this);
  m_document.halfTyped().disconnect(this);
  m_timer.stop();
  m_isDue = false;
  m_writing.reset();
  m_slot->remove();
}

void RecoveryKeeper::noteChange() {
  m_isSessionDue = true;
  schedule();
}

bool RecoveryKeeper::isNeeded() const {
  return m_document.isModified() || !m_document.halfTyped().isEmpty();
}

/// Schedules the next write; further keystrokes do not postpone it. A saved session needs no record.
void RecoveryKeeper::schedule() {
  if (!isNeeded())
    keep();
  else if (!m_timer.isActive())
    m_timer.start();
}

void RecoveryKeeper::keep() {
  if (m_writing->isAtWork()) {
    m_isDue = true;
    return;
  }
  if (!isNeeded()) {
    m_isSessionDue = true;
    return m_slot->remove();
  }
  m_writing->start([due = takeDue()](const std::stop_token&) { return write(due); },
                   [](const std::string& reason) { return Problem{.what = reason + '.', .where = {}}; });
}

RecoveryKeeper::Due RecoveryKeeper::takeDue() {
  Due due{.path = m_slot->path(),
          .typedPath = m_slot->typedPath(),
          .record = {},
          .id = {},
          .typed = m_document.halfTyped().texts()};
  if (std::exchange(m_isSessionDue, false)) {
    m_recordId = QUuid::createUuid().toString(QUuid::WithoutBraces);
    due.record = std::make_shared<const RecoveryRecord>(
        RecoveryRecord{m_document.path(), m_document.knownSha256(), QDateTime::currentDateTime(),
                       m_document.session(), m_recordId});
  }
  due.id = m_recordId;
  return due;
}

/// Writes the record first. The file of unfinished entries names the id of its record, so that entries of an
/// earlier record are ignored.
RecoveryKeeper::Written RecoveryKeeper::write(const Due& due) {
  if (due.record)
    if (Written problem = writePrivately(due.path, recoveryText(*due.record))) return problem;
  if (!due.typed.empty())
    return writePrivately(due.typedPath, halfTypedRecordText({.of = due.id, .texts = due.typed}));
  QFile::remove(due.typedPath);
  return {};
}

void RecoveryKeeper::finishWriting(const Written& problem) {
  constexpr int againMs = 5000;
  const QString trouble =
      problem ? tr("Unsaved changes would be lost in a crash: %1").arg(visibleLine(problem->text()))
              : QString();
  if (trouble != std::exchange(m_trouble, trouble)) emit troubled(trouble);
  if (problem) {
    m_isSessionDue = true;
    QTimer::singleShot(againMs, this, &RecoveryKeeper::schedule);
  }
  if (std::exchange(m_isDue, false)) keep();
}

}  // namespace alidade::ui
