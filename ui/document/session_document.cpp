#include "ui/document/session_document.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <iterator>
#include <utility>

#include "core/session/session_file.h"
#include "ui/document/field.h"

namespace alidade::ui {

SessionDocument::SessionDocument(QObject* parent) : QObject(parent), m_session(blankSession()) {
  connect(&m_undoStack, &QUndoStack::indexChanged, this, &SessionDocument::identityChanged);
}

QString SessionDocument::displayName() const {
  return path().isEmpty() ? tr("Untitled") : QFileInfo(path()).fileName();
}

void SessionDocument::push(QUndoCommand* command) {
  m_files.dropFrom(m_undoStack.index());
  m_undoStack.push(command);
}

void SessionDocument::pushAnother(QUndoCommand* command) {
  m_files.dropFrom(m_undoStack.index());
  m_files.beginAnother(m_undoStack.index());
  m_undoStack.push(command);
}

void SessionDocument::beginTogether(const QString& undoText) {
  m_files.dropFrom(m_undoStack.index());
  m_undoStack.beginMacro(undoText);
}

void SessionDocument::startNew() {
  replaceAll(blankSession(), {});
}

void SessionDocument::startWith(Session session) {
  replaceAll(std::move(session), {});
}

std::optional<Problem> SessionDocument::load(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    return Problem{tr("“%1” cannot be opened: %2").arg(path, file.errorString()).toStdString()};
  }
  file.close();
  Result<Session> session = loadSession(QFile::encodeName(path).toStdString());
  if (!session) return session.problem();
  replaceAll(*std::move(session), QFileInfo(path).absoluteFilePath());
  return {};
}

std::optional<Problem> SessionDocument::save(const QString& path) {
  const std::string text = writeSession(m_session);
  QSaveFile file(path);
  const auto size = static_cast<qint64>(text.size());
  if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), size) != size || !file.commit()) {
    return Problem{tr("“%1” cannot be saved: %2").arg(path, file.errorString()).toStdString()};
  }
  m_files.setSaved(m_undoStack.index(), QFileInfo(path).absoluteFilePath());
  emit identityChanged();
  return {};
}

void SessionDocument::putField(const Place& place, const std::string& text) {
  const Field* field = fieldNamed(place.field);
  Q_ASSERT(field);
  const SessionChange change{.kind = SessionChange::Kind::Field, .place = place};
  emit aboutToChange(change);
  field->at(m_session, place.position.value_or(0)) = text;
  emit changed(change);
}

void SessionDocument::putEffects(const std::vector<std::string>& effects) {
  const SessionChange change{.kind = SessionChange::Kind::Field, .place = {.field = "model.effects"}};
  emit aboutToChange(change);
  m_session.model.effects = effects;
  emit changed(change);
}

void SessionDocument::putReadings(std::size_t position, std::size_t first, std::size_t removed,
                                  const std::vector<Reading>& inserted) {
  const SessionChange change{.kind = SessionChange::Kind::Readings,
                             .place = {.position = position, .reading = first},
                             .removed = removed,
                             .inserted = inserted.size()};
  emit aboutToChange(change);
  std::vector<Reading>& readings = m_session.positions.at(position).readings;
  const auto from = std::next(readings.begin(), static_cast<std::ptrdiff_t>(first));
  const auto next = readings.erase(from, std::next(from, static_cast<std::ptrdiff_t>(removed)));
  readings.insert(next, inserted.begin(), inserted.end());
  emit changed(change);
}

void SessionDocument::insertPosition(std::size_t index, const Position& position) {
  const SessionChange change{
      .kind = SessionChange::Kind::Positions, .place = {.position = index}, .inserted = 1};
  emit aboutToChange(change);
  m_session.positions.insert(std::next(m_session.positions.begin(), static_cast<std::ptrdiff_t>(index)),
                             position);
  emit changed(change);
}

void SessionDocument::removePosition(std::size_t index) {
  const SessionChange change{
      .kind = SessionChange::Kind::Positions, .place = {.position = index}, .removed = 1};
  emit aboutToChange(change);
  m_session.positions.erase(std::next(m_session.positions.begin(), static_cast<std::ptrdiff_t>(index)));
  emit changed(change);
}

void SessionDocument::putSession(const Session& session) {
  emit aboutToChange({});
  m_session = session;
  emit changed({});
}

void SessionDocument::replaceAll(Session session, const QString& path) {
  emit aboutToChange({});
  m_session = std::move(session);
  m_undoStack.clear();
  m_files.restart(path);
  emit changed({});
  emit identityChanged();
}

}  // namespace alidade::ui
