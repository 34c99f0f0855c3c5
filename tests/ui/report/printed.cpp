#include "tests/ui/report/printed.h"

#include <QProcess>
#include <QRegularExpression>
#include <stdexcept>

namespace alidade::ui {

namespace {

QString output(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  if (!process.waitForFinished() || process.exitCode() != 0)
    throw std::runtime_error(program.toStdString() + ": " + process.errorString().toStdString());
  return QString::fromUtf8(process.readAllStandardOutput());
}

}  // namespace

QString printedText(const QString& path) {
  QString text = output(QStringLiteral("pdftotext"), {QStringLiteral("-layout"), path, QStringLiteral("-")});
  return text.replace(QRegularExpression(QStringLiteral(" +")), QStringLiteral(" "));
}

Printed::Printed(const Session& session, const ReportSource& source) {
  write(session, source, {.date = date()});
}

Printed::Printed(const Session& session, ReportOptions options) {
  options.date = date();
  write(session, savedSource(), options);
}

void Printed::write(const Session& session, const ReportSource& source, const ReportOptions& options) {
  const Result<QString> written = writeAcceptanceReport(evaluate(session), source, path(), options);
  if (!written) throw std::runtime_error(written.problem().text());
  m_pages = printedText(path()).split(u'\f', Qt::SkipEmptyParts);
}

bool Printed::contains(const char* text) const {
  return this->text().contains(QString::fromUtf8(text));
}

QString Printed::tool(const QString& program, const QStringList& arguments) const {
  return output(program, arguments.isEmpty() ? QStringList{path()} : arguments);
}

ReportSource Printed::savedSource() {
  return {.fileName = QStringLiteral("paper-table-1.alidade"),
          .sha256 = QByteArray::fromHex("00112233445566778899aabbccddeeff0123456789abcdeffedcba9876543210"),
          .saved = true};
}

}  // namespace alidade::ui
