#include "ui/recovery/drafts.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <QPointer>
#include <algorithm>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/file_bytes.h"
#include "ui/document/encoded_path.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

const QString draftsFormatName = QStringLiteral("alidade-drafts-1");

/// Empty if the file does not hold drafts.
QJsonObject draftsIn(const QString& path) {
  const Result<std::string> bytes = readFile(encodedPath(path));
  if (!bytes) return {};
  const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(*bytes)).object();
  const bool isOfDrafts = json.value(QLatin1String("format")).toString() == draftsFormatName;
  return isOfDrafts ? json.value(QLatin1String("forms")).toObject() : QJsonObject();
}

}  // namespace

Drafts::Drafts() {
  constexpr int delayMs = 250;
  m_timer.setSingleShot(true);
  m_timer.setInterval(delayMs);
  m_timer.callOnTimeout(this, &Drafts::keep);
}

Drafts::~Drafts() {
  keepNow();
}

void Drafts::keepIn(const QString& folder) {
  keepNow();
  m_all = {};
  m_slot.reset();
  if (folder.isEmpty()) return;
  m_slot = RecoverySlot::create(folder, RecoverySlot::Kind::Drafts);
  startWriter();
  adoptLeftBehind(folder);
}

/// A file waits for a later start if it has a draft of a form already restored from another file.
void Drafts::adoptLeftBehind(const QString& folder) {
  for (const auto& left : RecoverySlot::leftBehind(folder, RecoverySlot::Kind::Drafts)) {
    const QJsonObject forms = draftsIn(left->path());
    const QStringList names = forms.keys();
    if (std::ranges::any_of(names, [this](const QString& name) { return m_all.contains(name); })) continue;
    for (const QString& name : names) m_all[name] = forms[name];
    if (!m_all.isEmpty() && write(m_slot->path(), m_all)) return;  // writing failed: keep the files
    left->remove();
  }
}

void Drafts::startWriter() {
  m_writing = std::make_unique<Background<Written>>(
      [this](const std::shared_ptr<const Written>& problem) { finishWriting(*problem); });
}

/// Stores the draft and schedules the writing; further keystrokes do not postpone the writing.
void Drafts::set(const QString& form, const QJsonObject& draft) {
  if (!isKept() || of(form) == draft) return;
  if (draft.isEmpty())
    m_all.remove(form);
  else
    m_all[form] = draft;
  schedule();
}

void Drafts::schedule() {
  if (isKept() && !m_timer.isActive()) m_timer.start();
}

void Drafts::keep() {
  if (m_writing->isAtWork()) {
    m_isDue = true;
    return;
  }
  m_writing->start([path = m_slot->path(), all = m_all](const std::stop_token&) { return write(path, all); },
                   [](const std::string& reason) { return Problem{.what = reason + '.', .where = {}}; });
}

void Drafts::keepNow() {
  if (!isKept()) return;
  const bool isDue = m_timer.isActive() || m_isDue || m_writing->isAtWork();
  m_timer.stop();
  m_writing.reset();  // waits for the running write
  startWriter();
  m_isDue = false;
  if (isDue) finishWriting(write(m_slot->path(), m_all));
}

Drafts::Written Drafts::write(const QString& path, const QJsonObject& all) {
  if (all.isEmpty()) {
    QFile::remove(path);
    return {};
  }
  const QJsonObject json{{QStringLiteral("format"), draftsFormatName}, {QStringLiteral("forms"), all}};
  const std::string text = QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
  return writeFiles({{.path = encodedPath(path), .bytes = text, .isPrivate = true}}, {});
}

void Drafts::finishWriting(const Written& problem) {
  constexpr int againMs = 5000;
  const QString trouble =
      problem
          ? tr("What is typed into this form would be lost in a crash: %1").arg(visibleLine(problem->text()))
          : QString();
  if (trouble != std::exchange(m_trouble, trouble)) emit troubled(trouble);
  if (problem) QTimer::singleShot(againMs, this, &Drafts::schedule);
  if (std::exchange(m_isDue, false)) keep();
}

Drafts& drafts() {
  static QPointer<Drafts> ofProcess;
  if (!ofProcess) {
    ofProcess = new Drafts;
    ofProcess->setParent(QCoreApplication::instance());
  }
  return *ofProcess;
}

}  // namespace alidade::ui
