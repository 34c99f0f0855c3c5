#include "tests/ui/report/printed.h"

#include <QProcess>
#include <QRegularExpression>
#include <stdexcept>

namespace alidade::ui {

Printed::Printed(const Session& session, const ReportSource& source) {
  const Result<QString> written = writeAcceptanceReport(evaluate(session), source, path(), {.date = date()});
  if (!written) throw std::runtime_error(written.problem().text());
  QString text = tool(QStringLiteral("pdftotext"), {QStringLiteral("-layout"), path(), QStringLiteral("-")});
  text.replace(QRegularExpression(QStringLiteral(" +")), QStringLiteral(" "));
  m_pages = text.split(u'\f', Qt::SkipEmptyParts);
}

bool Printed::contains(const char* text) const {
  return this->text().contains(QString::fromUtf8(text));
}

QString Printed::tool(const QString& program, const QStringList& arguments) const {
  QProcess process;
  process.start(program, arguments.isEmpty() ? QStringList{path()} : arguments);
  if (!process.waitForFinished() || process.exitCode() != 0)
    throw std::runtime_error(program.toStdString() + ": " + process.errorString().toStdString());
  return QString::fromUtf8(process.readAllStandardOutput());
}

ReportSource Printed::savedSource() {
  return {.fileName = QStringLiteral("paper-table-1.alidade"),
          .sha256 = QByteArray::fromHex("00112233445566778899aabbccddeeff0123456789abcdeffedcba9876543210"),
          .saved = true};
}

}  // namespace alidade::ui
