#include "ui/recovery/recovery_keeper.h"

#include <QFile>
#include <utility>

#include "core/base/atomic_file.h"
#include "ui/document/session_document.h"
#include "ui/recovery/recovery_record.h"
#include "ui/text/encoded_path.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

RecoveryKeeper::RecoveryKeeper(SessionDocument& document, const QString& folder, QObject* parent)
    : QObject(parent), m_document(document), m_slot(RecoverySlot::create(folder)) {
  constexpr int delayMs = 250;
  m_timer.setSingleShot(true);
  m_timer.setInterval(delayMs);
  m_writing = std::make_unique<Background<Written>>(
      [this](const std::shared_ptr<const Written>& problem) { finishWriting(*problem); });
  connect(&m_timer, &QTimer::timeout, this, &RecoveryKeeper::keep);
  connect(&document, &SessionDocument::changed, this, &RecoveryKeeper::schedule);
  connect(&document, &SessionDocument::identityChanged, this, &RecoveryKeeper::schedule);
}

void RecoveryKeeper::adopt(std::unique_ptr<RecoverySlot> slot) {
  std::swap(m_slot, slot);
  QFile::remove(slot->path());
  schedule();
}

void RecoveryKeeper::finish() {
  m_document.disconnect(this);
  m_timer.stop();
  m_isDue = false;
  m_writing.reset();
  m_slot->remove();
}

/// Not put off by further edits. What was saved needs no record from then on.
void RecoveryKeeper::schedule() {
  if (!m_document.isModified())
    keep();
  else if (!m_timer.isActive())
    m_timer.start();
}

void RecoveryKeeper::keep() {
  if (m_writing->isAtWork()) {
    m_isDue = true;
    return;
  }
  if (!m_document.isModified()) return m_slot->remove();
  auto record = std::make_shared<const RecoveryRecord>(RecoveryRecord{
      m_document.path(), m_document.knownSha256(), QDateTime::currentDateTime(), m_document.session()});
  m_writing->start([record, path = encodedPath(m_slot->path())](
                       const std::stop_token&) { return writeFile(path, recoveryText(*record)); },
                   [](const std::string& reason) { return Problem{.what = reason + '.', .where = {}}; });
}

void RecoveryKeeper::finishWriting(const Written& problem) {
  if (problem && !m_hasFailed)
    emit failed(tr("Unsaved changes would be lost in a crash: %1").arg(visibleLine(problem->text())));
  m_hasFailed = problem.has_value();
  if (std::exchange(m_isDue, false)) keep();
}

}  // namespace alidade::ui
