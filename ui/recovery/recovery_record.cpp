#include "ui/recovery/recovery_record.h"

#include <QJsonDocument>
#include <QJsonObject>

#include "core/base/phrase.h"
#include "core/session/session_file.h"

namespace alidade::ui {

namespace {

const QString formatKey = QStringLiteral("format");
const QString formatName = QStringLiteral("alidade-recovery-1");

}  // namespace

std::string recoveryText(const RecoveryRecord& record) {
  const QJsonObject head{{formatKey, formatName},
                         {QStringLiteral("file"), record.path},
                         {QStringLiteral("sha256"), QString::fromLatin1(record.sha256.toHex())},
                         {QStringLiteral("kept_at"), record.keptAt.toString(Qt::ISODateWithMs)},
                         {QStringLiteral("id"), record.id}};
  return QJsonDocument(head).toJson(QJsonDocument::Compact).toStdString() + '\n' +
         writeSession(record.session);
}

Result<RecoveryRecord> readRecovery(const std::string& bytes) {
  const std::size_t end = bytes.find('\n');
  const QByteArray line = QByteArray::fromStdString(bytes.substr(0, end));
  const QJsonObject head = QJsonDocument::fromJson(line).object();
  if (end == std::string::npos || head.value(formatKey).toString() != formatName)
    return Problem{Phrase::of("is not a file of unsaved changes")};
  Result<Session> session = readSession(std::string_view(bytes).substr(end + 1));
  if (!session) return session.problem();
  const auto text = [&head](const char* key) { return head.value(QLatin1String(key)).toString(); };
  return RecoveryRecord{text("file"), QByteArray::fromHex(text("sha256").toLatin1()),
                        QDateTime::fromString(text("kept_at"), Qt::ISODateWithMs), *std::move(session),
                        text("id")};
}

}  // namespace alidade::ui
