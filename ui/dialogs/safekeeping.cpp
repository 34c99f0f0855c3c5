#include "ui/dialogs/safekeeping.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <utility>

#include "core/base/file_bytes.h"
#include "core/session/session_file.h"
#include "ui/commands/hand_in.h"
#include "ui/commands/session_commands.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/file_flow.h"
#include "ui/document/encoded_path.h"
#include "ui/document/session_document.h"
#include "ui/document/session_template.h"
#include "ui/recovery/drafts.h"
#include "ui/recovery/half_typed_record.h"
#include "ui/settings/theme.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

Result<std::string> bytesOf(const QString& path) {
  return readFile(encodedPath(path));
}

/// The session with which a recovery record is compared: the record's file, or a new session without a file.
struct ComparedFile {
  Session session = templateSession();
  QString state;  ///< place of the file and whether the file has changed
};

ComparedFile comparedFile(const RecoveryRecord& record) {
  if (record.path.isEmpty()) return {.state = Safekeeping::tr("not saved to a file yet")};
  const QString place = Safekeeping::tr("in %1").arg(visibleLine(QDir::toNativeSeparators(record.path)));
  const auto inPlace = [&place](const QString& more) { return listText({place, more}); };
  if (!QFileInfo(record.path).isFile())
    return {.state = inPlace(Safekeeping::tr("which is no longer there"))};
  const Result<std::string> bytes = bytesOf(record.path);
  Result<Session> session = bytes ? readSession(*bytes) : bytes.problem();
  if (!session) return {.state = inPlace(Safekeeping::tr("which cannot be read any more"))};
  const QByteArray hash =
      QCryptographicHash::hash(QByteArray::fromStdString(*bytes), QCryptographicHash::Sha256);
  return {*std::move(session),
          hash == record.sha256
              ? place
              : inPlace(Safekeeping::tr("which has changed since Alidade last read or saved it"))};
}

/// The unfinished entries that were stored for the record; `path`: file of the unfinished entries.
std::vector<HalfTypedText> typedInto(const RecoveryRecord& record, const QString& path) {
  if (record.id.isEmpty() || !QFileInfo::exists(path)) return {};
  const Result<std::string> bytes = bytesOf(path);
  const Result<HalfTypedRecord> typed = bytes ? readHalfTypedRecord(*bytes) : bytes.problem();
  return typed && typed->of == record.id ? typed->texts : std::vector<HalfTypedText>();
}

RecoveryOffer offerOf(const RecoveryRecord& record, const std::vector<HalfTypedText>& typed) {
  const ComparedFile file = comparedFile(record);
  const QString title = qText(record.session.title).trimmed();
  const QString untitled = title.isEmpty() ? Safekeeping::tr("Untitled") : title;
  return {.name = visibleLine(record.path.isEmpty() ? untitled : QFileInfo(record.path).fileName()),
          .details = Safekeeping::tr("%1; kept on %2")
                         .arg(file.state, QLocale().toString(record.keptAt, QLocale::ShortFormat)),
          .difference = differenceOf(withHandedIn(record.session, typed), file.session)};
}

}  // namespace

Safekeeping::Safekeeping(SessionDocument& document, FileFlow& files, Dialogs& dialogs, const QString& folder,
                         QObject* parent)
    : QObject(parent),
      m_document(document),
      m_files(files),
      m_dialogs(dialogs),
      m_folder(folder),
      m_keeper(document, folder),
      m_trouble(new QLabel) {
  m_trouble->setObjectName(QStringLiteral("safekeeping trouble"));
  m_trouble->setTextFormat(Qt::PlainText);
  m_trouble->hide();
  drafts().keepIn(folder);
  const auto follow = [this](QString Safekeeping::*trouble) {
    return [this, trouble](const QString& sentence) {
      this->*trouble = sentence;
      showTrouble();
    };
  };
  connect(&m_keeper, &RecoveryKeeper::troubled, this, follow(&Safekeeping::m_recordTrouble));
  connect(&drafts(), &Drafts::troubled, this, follow(&Safekeeping::m_draftsTrouble));
}

Safekeeping::~Safekeeping() {
  drafts().keepIn({});
}

void Safekeeping::keepNow() {
  m_keeper.keepNow();
  drafts().keepNow();
}

void Safekeeping::showTrouble() {
  const QString& sentence = m_recordTrouble.isEmpty() ? m_draftsTrouble : m_recordTrouble;
  QPalette colored = m_trouble->parentWidget() ? m_trouble->parentWidget()->palette() : m_trouble->palette();
  colored.setColor(QPalette::WindowText, stateColor(colored, State::Bad));
  m_trouble->setPalette(colored);
  m_trouble->setText(sentence.isEmpty() ? QString() : tr("Unsaved changes are not kept: save now"));
  m_trouble->setToolTip(sentence);
  m_trouble->setVisible(!sentence.isEmpty());
  if (!sentence.isEmpty()) emit remark(sentence);
}

int Safekeeping::offer() {
  std::vector<Left> left = leftBehind();
  int questions = 0;
  while (!left.empty()) {
    QList<RecoveryOffer> offers;
    for (const Left& one : left) offers.append(one.offer);
    const RecoveryAnswer answer = m_dialogs.askRecovery(offers);
    ++questions;
    const auto chosen = left.begin() + answer.index;
    if (answer.choice == RecoveryAnswer::Choice::Discard) {
      chosen->slot->remove();
      left.erase(chosen);
    } else if (answer.choice != RecoveryAnswer::Choice::Recover || recover(*chosen)) {
      break;
    }
  }
  return questions;
}

std::vector<Safekeeping::Left> Safekeeping::leftBehind() {
  std::vector<Left> left;
  for (std::unique_ptr<RecoverySlot>& slot : RecoverySlot::leftBehind(m_folder)) {
    const Result<std::string> bytes = bytesOf(slot->path());
    Result<RecoveryRecord> record = bytes ? readRecovery(*bytes) : bytes.problem();
    if (!record) {
      emit remark(tr("Unsaved changes in %1 cannot be read: %2")
                      .arg(QDir::toNativeSeparators(slot->path()), visibleLine(record.problem().text())));
      continue;
    }
    std::vector<HalfTypedText> typed = typedInto(*record, slot->typedPath());
    RecoveryOffer offer = offerOf(*record, typed);
    if (offer.difference.count == 0)
      slot->remove();
    else
      left.push_back({std::move(slot), *std::move(record), std::move(typed), std::move(offer)});
  }
  return left;
}

/// Restores the changes as unsaved changes of their file; undo returns to the file's content. The window
/// takes over the record, so that a record exists at every moment.
bool Safekeeping::recover(Left& left) {
  if (!m_files.mayLeave()) return false;
  const QString& path = left.record.path;
  const bool isInFile = QFileInfo(path).isFile() && !m_document.load(path);
  if (!isInFile) m_document.startNew();
  if (left.record.session != m_document.session())
    m_document.push(new ReplaceSession(m_document, std::move(left.record.session),
                                       tr("Recover unsaved changes"), path.isEmpty()));
  handIn(m_document, left.typed);
  m_keeper.adopt(std::move(left.slot));
  emit remark(tr("Recovered %1; not saved yet").arg(left.offer.name));
  return true;
}

}  // namespace alidade::ui
