#include "ui/jobs/failed_job.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QSysInfo>
#include <map>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/version.h"
#include "core/session/session_file.h"
#include "ui/document/encoded_path.h"
#include "ui/document/private_folder.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

constexpr int mostRecords = 50;

/// The text of a record, with the session's file text: Qt's JSON keeps neither the key order nor all digits.
QByteArray recordOf(const FailedJob& failed, const QDateTime& now) {
  QJsonObject head{{QStringLiteral("program"), qText("Alidade " + versionAndBuild())},
                   {QStringLiteral("qt"), QString::fromLatin1(qVersion())},
                   {QStringLiteral("system"), QSysInfo::prettyProductName()},
                   {QStringLiteral("time"), now.toString(Qt::ISODateWithMs)},
                   {QStringLiteral("job"), qText(failed.job)},
                   {QStringLiteral("reason"), qText(failed.reason)}};
  if (failed.seed) head.insert(QStringLiteral("seed"), QString::number(*failed.seed));
  QByteArray record = QJsonDocument(head).toJson();
  if (!failed.session) return record;
  record.chop(static_cast<int>(qstrlen("\n}\n")));
  return record + ",\n    \"session\": " + QByteArray::fromStdString(writeSession(*failed.session)) + "}\n";
}

/// Keeps the newest `mostRecords` records; their names sort by time.
void dropOldest(const QDir& folder) {
  QStringList records = folder.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name);
  while (records.size() > mostRecords) QFile::remove(folder.filePath(records.takeFirst()));
}

/// A free file name, since several jobs may fail within a millisecond.
QString unusedName(const QDir& folder, const QString& name) {
  const QString suffix = QStringLiteral(".json");
  QString path = folder.filePath(name + suffix);
  for (int i = 2; QFile::exists(path); ++i)
    path = folder.filePath(name + QStringLiteral("-%1").arg(i) + suffix);
  return path;
}

/// The path of the record; empty if writing failed.
QString written(const FailedJob& failed) {
  const QDir folder(problemsFolder());
  makePrivateFolder(folder.path());
  if (!folder.exists()) return {};
  const QDateTime now = QDateTime::currentDateTime();
  QString job = qText(failed.job);
  job.replace(QLatin1Char(' '), QLatin1Char('-'));
  const QString path = unusedName(folder, now.toString(QStringLiteral("yyyyMMdd-HHmmss-zzz-")) + job);
  const QByteArray record = recordOf(failed, now);
  const auto problem =
      writeFile(encodedPath(path), {record.constData(), static_cast<std::size_t>(record.size())}, {});
  dropOldest(folder);
  return problem ? QString() : path;
}

/// Writes one record per job and reason, since otherwise every edit would add a record.
QString writtenOnce(const FailedJob& failed) {
  static std::map<std::pair<std::string, std::string>, QString> records;
  QString& path = records[{failed.job, failed.reason}];
  if (path.isEmpty() || !QFile::exists(path)) path = written(failed);
  return path;
}

}  // namespace

QString problemsFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/problems");
}

FailedWork recorded(const FailedJob& failed) {
  FailedWork work{.work = failed.job, .reason = failed.reason};
  failureOf([&] {
    const QString path = writtenOnce(failed);
    work.isRecorded = !path.isEmpty();
    work.record = QDir::toNativeSeparators(work.isRecorded ? path : problemsFolder()).toStdString();
  });
  return work;
}

std::string reportFailure(const FailedJob& failed) {
  std::string text = "The " + failed.job + " failed: " + failed.reason + ".";
  failureOf([&] { text = sentencesOf(recorded(failed)); });
  return text;
}

}  // namespace alidade::ui
