#include "ui/document/session_document.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <iterator>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/file_bytes.h"
#include "core/session/session_file.h"
#include "ui/document/field.h"

namespace alidade::ui {

namespace {

QByteArray sha256(const std::string& bytes) {
  return QCryptographicHash::hash({bytes.data(), static_cast<qsizetype>(bytes.size())},
                                  QCryptographicHash::Sha256);
}

}  // namespace

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
  const Result<std::string> bytes = readFile(QFile::encodeName(path).toStdString());
  if (!bytes) return bytes.problem();
  Result<Session> session = readSession(*bytes);
  if (!session) return session.problem();
  const QString absolute = QFileInfo(path).absoluteFilePath();
  m_knownSha256[absolute] = sha256(*bytes);
  replaceAll(*std::move(session), absolute);
  return {};
}

std::optional<Problem> SessionDocument::save(const QString& path) {
  const std::string text = writeSession(m_session);
  if (auto problem = writeFile(QFile::encodeName(path).toStdString(), text)) return problem;
  m_files.setSaved(m_undoStack.index(), QFileInfo(path).absoluteFilePath());
  markSaved(text);
  return {};
}

std::optional<std::string> SessionDocument::bytesOfOthers() const {
  if (!QFileInfo(path()).isFile()) return {};
  Result<std::string> bytes = readFile(QFile::encodeName(path()).toStdString());
  if (!bytes || sha256(*bytes) == knownSha256()) return {};
  return *std::move(bytes);
}

void SessionDocument::markSaved(const std::string& bytes) {
  m_files.setSaved(m_undoStack.index(), path());
  m_knownSha256[path()] = sha256(bytes);
  emit identityChanged();
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
