#include "ui/report/attached_session.h"

#include <QFile>

#include "core/base/file_bytes.h"
#include "core/base/limits.h"
#include "core/session/session_file.h"
#include "ui/document/encoded_path.h"
#include "ui/report/pdf_attachments.h"
#include "ui/report/report_text.h"

namespace alidade::ui {

namespace {

const QString suffix = QStringLiteral(".alidade");

Problem problemOf(const QString& text) {
  return Problem{text.toStdString()};
}

}  // namespace

QString attachedName(const QString& fileName) {
  if (fileName.isEmpty()) return QStringLiteral("session") + suffix;
  return fileName.endsWith(suffix, Qt::CaseInsensitive) ? fileName : fileName + suffix;
}

bool isPdfFile(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) && file.read(5) == "%PDF-";
}

Result<std::string> attachedSessionText(std::string_view pdf) {
  AttachedFile file = attachedFile(pdf, suffix.toStdString(), {.mostBytes = limits::mostBytes});
  switch (file.outcome) {
    case AttachedFile::Outcome::Found:
      return std::move(file.bytes);
    case AttachedFile::Outcome::NotThere:
      return problemOf(
          Report::tr("No session is attached to this PDF: a report of Alidade contains its session unless "
                     "the session was left out"));
    case AttachedFile::Outcome::Missing:
      return problemOf(Report::tr("The PDF cannot be read (the session attached to it is missing)"));
    case AttachedFile::Outcome::TooLarge:
      return limits::tooManyBytes();
    case AttachedFile::Outcome::Damaged:
      return problemOf(Report::tr("The PDF cannot be read (the session attached to it is damaged)"));
    case AttachedFile::Outcome::Exhausting:
      return problemOf(Report::tr(
          "The PDF cannot be read (it takes more memory or time than a report does): choose another file"));
    case AttachedFile::Outcome::Unreadable:
      break;
  }
  return problemOf(Report::tr("The PDF cannot be read (%1)").arg(QString::fromStdString(file.failure)));
}

Result<Session> readAttachedSession(const QString& path) {
  const Result<std::string> pdf = readFile(encodedPath(path));
  if (!pdf) return pdf.problem();
  const Result<std::string> text = attachedSessionText(*pdf);
  if (!text) return text.problem();
  return readSession(*text);
}

}  // namespace alidade::ui
