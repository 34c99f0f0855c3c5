#include "ui/document/session_document.h"

#include <QFileInfo>
#include <iterator>
#include <utility>

#include "core/session/session_file.h"
#include "ui/document/disposal.h"
#include "ui/document/field.h"
#include "ui/document/known_entry.h"
#include "ui/document/readings_patch.h"

namespace alidade::ui {

namespace {

SessionChange changeOf(std::size_t position, const std::shared_ptr<const ReadingsPatch>& patch,
                       bool isReverted) {
  const RowSpan span = patch->span();
  return {.kind = SessionChange::Kind::Readings,
          .place = {.position = position, .reading = span.first},
          .removed = isReverted ? span.after : span.before,
          .inserted = isReverted ? span.before : span.after,
          .patch = patch,
          .isReverted = isReverted};
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
  m_journal.dropFrom(m_undoStack.index());
  m_undoStack.push(command);
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
}

void SessionDocument::startNew() {
  replaceAll(blankSession(), {}, true);
}

void SessionDocument::startWith(Session session) {
  replaceAll(std::move(session), {}, true);
}

void SessionDocument::startWithStanding(Session session) {
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

SessionChange SessionDocument::told(SessionChange change) {
  change.journalKept = m_journal.takeKept();
  return change;
}

void SessionDocument::putField(const Place& place, const std::string& text) {
  const Field* field = fieldNamed(place.field);
  Q_ASSERT(field);
  const SessionChange change = told({.kind = SessionChange::Kind::Field, .place = place});
  emit aboutToChange(change);
  field->at(m_session, place.position.value_or(0)) = text;
  emit changed(change);
}

void SessionDocument::putEffects(const std::vector<std::string>& effects) {
  const SessionChange change =
      told({.kind = SessionChange::Kind::Field, .place = {.field = "model.effects"}});
  emit aboutToChange(change);
  m_session.model.effects = effects;
  emit changed(change);
}

void SessionDocument::putOwnEffects(const std::vector<OwnEffect>& effects) {
  const SessionChange change = told({.kind = SessionChange::Kind::Field, .place = {.field = "own_effects"}});
  emit aboutToChange(change);
  m_session.ownEffects = effects;
  emit changed(change);
}

void SessionDocument::putKnown(const Place& place, bool isThere, const std::optional<KnownSize>& size) {
  const KnownRef ref = knownAt(place).value().ref;
  const SessionChange change = told({.kind = SessionChange::Kind::Field, .place = place});
  emit aboutToChange(change);
  std::vector<KnownSize>& list = knownBy(m_session, ref.owner);
  const auto at = std::next(list.begin(), static_cast<std::ptrdiff_t>(ref.index));
  if (isThere && size)
    *at = *size;
  else if (size)
    list.insert(at, *size);
  else
    list.erase(at);
  emit changed(change);
}

void SessionDocument::putInstrument(const Instrument& instrument) {
  const SessionChange change = told({});
  emit aboutToChange(change);
  m_session.instrument = instrument;
  emit changed(change);
}

void SessionDocument::patchReadings(std::size_t position, const std::shared_ptr<const ReadingsPatch>& patch) {
  const SessionChange change = told(changeOf(position, patch, false));
  emit aboutToChange(change);
  patch->apply(m_session.positions.at(position).readings);
  emit changed(change);
}

void SessionDocument::revertReadings(std::size_t position,
                                     const std::shared_ptr<const ReadingsPatch>& patch) {
  const SessionChange change = told(changeOf(position, patch, true));
  emit aboutToChange(change);
  patch->revert(m_session.positions.at(position).readings);
  emit changed(change);
}

void SessionDocument::insertPosition(std::size_t index, const Position& position) {
  const SessionChange change =
      told({.kind = SessionChange::Kind::Positions, .place = {.position = index}, .inserted = 1});
  emit aboutToChange(change);
  m_session.positions.insert(std::next(m_session.positions.begin(), static_cast<std::ptrdiff_t>(index)),
                             position);
  emit changed(change);
}

void SessionDocument::removePosition(std::size_t index) {
  const SessionChange change =
      told({.kind = SessionChange::Kind::Positions, .place = {.position = index}, .removed = 1});
  emit aboutToChange(change);
  m_session.positions.erase(std::next(m_session.positions.begin(), static_cast<std::ptrdiff_t>(index)));
  emit changed(change);
}

void SessionDocument::exchangeSession(Session& session, JournalKeeper::State& state) {
  emit aboutToChange({});
  std::swap(m_session, session);
  m_journal.exchange(state);
  emit changed({});
}

void SessionDocument::exchangeContent(Session& session) {
  const SessionChange change = told({});
  emit aboutToChange(change);
  std::swap(m_session, session);
  std::swap(m_session.journal, session.journal);
  emit changed(change);
}

void SessionDocument::tellOfJournal() {
  const SessionChange change = told({.kind = SessionChange::Kind::Field, .place = {.field = "journal"}});
  emit aboutToChange(change);
  emit changed(change);
}

void SessionDocument::replaceAll(Session session, const QString& path, bool isNew) {
  emit aboutToChange({});
  sharedAside(std::exchange(m_session, std::move(session)));
  m_undoStack.clear();
  m_files.restart(path);
  m_readPaths.clear();
  m_journal.restart(isNew);
  emit changed({});
  emit identityChanged();
}

}  // namespace alidade::ui
