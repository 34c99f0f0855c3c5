#include "ui/document/session_document.h"

#include <QFileInfo>
#include <utility>

#include "core/session/session_file.h"
#include "ui/document/session_template.h"

namespace alidade::ui {

SessionDocument::SessionDocument(QObject* parent) : QObject(parent), m_session(templateSession()) {
  connect(&m_undoStack, &QUndoStack::indexChanged, this, &SessionDocument::identityChanged);
}

QString SessionDocument::displayName() const {
  return path().isEmpty() ? tr("Untitled") : QFileInfo(path()).fileName();
}

void SessionDocument::push(QUndoCommand* command) {
  m_files.dropFrom(m_undoStack.index());
  m_journal.dropFrom(m_undoStack.index());
  const std::size_t before = m_session.journal.size();
  m_undoStack.push(command);
  if (!m_journalBefore) emitRecorded(before);
}

void SessionDocument::pushAnother(QUndoCommand* command) {
  m_files.dropFrom(m_undoStack.index());
  m_journal.dropFrom(m_undoStack.index());
  m_files.beginAnother(m_undoStack.index());
  m_undoStack.push(command);
}

void SessionDocument::beginTogether(const QString& undoText) {
  m_files.dropFrom(m_undoStack.index());
  m_journal.dropFrom(m_undoStack.index());
  m_undoStack.beginMacro(undoText);
  m_journalBefore = m_session.journal.size();
}

void SessionDocument::endTogether() {
  m_undoStack.endMacro();
  if (m_journalBefore) emitRecorded(*std::exchange(m_journalBefore, std::nullopt));
}

void SessionDocument::emitRecorded(std::size_t first) {
  if (m_session.journal.size() > first) emit recorded(first);
}

void SessionDocument::startNew() {
  replaceAll(templateSession(), {}, true);
}

void SessionDocument::startWith(Session session) {
  replaceAll(std::move(session), {}, true);
}

void SessionDocument::startWithRecorded(Session session) {
  replaceAll(std::move(session), {}, false);
}

std::optional<Problem> SessionDocument::load(const QString& path) {
  Result<FiledSession> file = readFiled(path);
  if (!file) return file.problem();
  startFrom(*std::move(file), path);
  return {};
}

void SessionDocument::startFrom(FiledSession file, const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  m_knownSha256[absolute] = file.sha256;
  replaceAll(std::move(file.session), absolute, false);
}

std::optional<Problem> SessionDocument::save(const QString& path) {
  const Result<QByteArray> written = writeFiled(m_session, path, m_readPaths);
  if (!written) return written.problem();
  markSaved(path, *written);
  return {};
}

void SessionDocument::markSaved(const QString& path, const QByteArray& sha256) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  m_files.setSaved(m_undoStack.index(), absolute);
  m_journal.setFiled(m_undoStack.index());
  m_knownSha256[absolute] = sha256;
  emit identityChanged();
}

void SessionDocument::markFileGone() {
  m_files.setUnsaved(m_undoStack.index());
  emit identityChanged();
}

void SessionDocument::edit(EditKey /*key*/, const SessionChange& change,
                           const std::function<void(Session&)>& write) {
  emit aboutToChange(change);
  write(m_session);
  if (change.kind == SessionChange::Kind::Everything || change.place.field == "protocol")
    m_chosenSighting.reset();
  emit changed(change);
}

void SessionDocument::setChosenSighting(std::optional<std::size_t> chosen) {
  if (std::exchange(m_chosenSighting, chosen) != chosen) emit chosenSightingChanged();
}

void SessionDocument::replaceAll(Session session, const QString& path, bool isNew) {
  emit aboutToChange({});
  m_session = std::move(session);
  m_chosenSighting.reset();
  m_undoStack.clear();
  m_files.restart(path);
  m_readPaths.clear();
  m_journal.restart(isNew);
  emit changed({});
  emit identityChanged();
}

}  // namespace alidade::ui
