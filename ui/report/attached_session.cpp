#include "ui/report/attached_session.h"

#include <QFile>
#include <exception>
#include <qpdf/Pipeline.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <stdexcept>

#include "core/base/file_bytes.h"
#include "core/base/limits.h"
#include "core/session/session_file.h"
#include "ui/report/report_text.h"
#include "ui/text/encoded_path.h"

namespace alidade::ui {

namespace {

const QString suffix = QStringLiteral(".alidade");

/// Takes what a stream holds, up to the limit of any file: a few bytes may unfold to very many.
class Taken : public Pipeline {
 public:
  Taken() : Pipeline("session", nullptr) {}

  void write(const unsigned char* data, std::size_t length) override {
    if (m_text.size() + length > limits::mostBytes) m_isTooMuch = true;
    if (m_isTooMuch) throw std::length_error("too much");
    m_text.append(reinterpret_cast<const char*>(data), length);
  }
  void finish() override {}

  bool isTooMuch() const { return m_isTooMuch; }
  std::string& text() { return m_text; }

 private:
  std::string m_text;
  bool m_isTooMuch = false;
};

Problem problemOf(const QString& text) {
  return Problem{text.toStdString()};
}

Result<std::string> contentOf(QPDFObjectHandle stream) {
  Taken taken;
  if (!stream.isStream())
    return problemOf(Report::tr("The PDF cannot be read (the session attached to it is missing)"));
  const bool isWhole = stream.pipeStreamData(&taken, nullptr, 0, qpdf_dl_generalized, true);
  if (taken.isTooMuch()) return limits::tooManyBytes();
  if (!isWhole)
    return problemOf(Report::tr("The PDF cannot be read (the session attached to it is damaged)"));
  return std::move(taken.text());
}

Result<std::string> sessionIn(QPDF& pdf) {
  QPDFEmbeddedFileDocumentHelper files(pdf);
  for (const auto& [name, file] : files.getEmbeddedFiles())
    if (QString::fromStdString(file->getFilename()).endsWith(suffix, Qt::CaseInsensitive))
      return contentOf(file->getEmbeddedFileStream());
  return problemOf(Report::tr(
      "No session is attached to this PDF: a report of Alidade holds its session unless that was left out"));
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
  try {
    QPDF document;
    document.setSuppressWarnings(true);
    document.processMemoryFile("report", pdf.data(), pdf.size());
    return sessionIn(document);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    return problemOf(Report::tr("The PDF cannot be read (%1)").arg(QString::fromUtf8(failure.what())));
  }
}

Result<Session> readAttachedSession(const QString& path) {
  const Result<std::string> pdf = readFile(encodedPath(path));
  if (!pdf) return pdf.problem();
  const Result<std::string> text = attachedSessionText(*pdf);
  if (!text) return text.problem();
  return readSession(*text);
}

}  // namespace alidade::ui
