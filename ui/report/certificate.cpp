#include "ui/report/certificate.h"

#include <QFileInfo>
#include <utility>

#include "core/answers/fit_answer.h"
#include "core/base/phrase.h"
#include "core/base/version.h"
#include "core/certificate/calibration_certificate.h"
#include "core/session/session_file.h"
#include "ui/language/languages.h"
#include "ui/report/attached_session.h"
#include "ui/report/report_text.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {
namespace {

/// The certificate language for the id of a `LanguageInfo`: "zh_CN" becomes zh.
CertificateLanguage languageOf(const QString& id) {
  return {id.section(u'_', 0, 0).toStdString(), [id](const Say& text) {
            const LanguageScope scope(id);
            return text();
          }};
}

/// English, which is the binding language, then the report's language if it is another.
std::vector<CertificateLanguage> languagesOf(const ReportOptions& report) {
  const QString english = QStringLiteral("en");
  const QString other = report.language.isEmpty() ? shownLanguage() : report.language;
  std::vector<CertificateLanguage> languages{languageOf(english)};
  if (other != english) languages.push_back(languageOf(other));
  return languages;
}

}  // namespace

Result<WrittenCertificate> certificateOf(const ReportSource& source, const ReportOptions& report,
                                         const CertificateEntries& entries, const std::string& pdf,
                                         const QString& pdfName) {
  const Gap& gap = *report.gap;
  const Session& session = gap.evaluation->session;
  const std::string name = session.title.empty() ? source.fileName.toStdString() : session.title;
  const std::string bytes = source.bytesOf(session);
  const Result<FitAnswer> answer = fitAnswerOf(gap, name, bytes);
  if (!answer) return answer.problem();
  CertificateOptions options{.version = versionAndBuild(),
                             .measuredOn = entries.measuredOn.toStdString(),
                             .country = entries.country.toStdString(),
                             .performedAt = entries.performedAt.toStdString(),
                             .manufacturer = entries.manufacturer.toStdString(),
                             .issued = report.date.date().toString(Qt::ISODate).toStdString(),
                             .isDraft = entries.isDraft,
                             .languages = languagesOf(report)};
  if (!pdf.empty()) options.report = CertificateDocument{pdfName.toStdString(), "application/pdf", pdf};
  const auto certificate =
      calibrationCertificate({session, *answer, attachedName(source.fileName).toStdString(), bytes}, options);
  if (!certificate) return certificate.problem();
  WrittenCertificate written{certificate->xml, {}};
  for (const char* noun : certificate->notStated) written.notStated.append(qText(Phrase::of(noun)));
  return written;
}

Result<QStringList> writeCertificate(const ReportSource& source, const QString& outPath,
                                     const ReportOptions& report, const CertificateEntries& entries) {
  // Checks first whether a certificate is possible, since painting the pages takes longer.
  if (const auto bare = certificateOf(source, report, entries); !bare) return bare.problem();
  const Result<std::string> pdf = acceptanceReportPdf(*report.gap->evaluation, source, report);
  if (!pdf) return pdf.problem();
  const QString pdfName = QFileInfo(outPath).completeBaseName() + QStringLiteral(".pdf");
  const auto certificate = certificateOf(source, report, entries, *pdf, pdfName);
  if (!certificate) return certificate.problem();
  if (auto problem = writeSigned(outPath, certificate->xml, report.signer, source))
    return *std::move(problem);
  return certificate->notStated;
}

}  // namespace alidade::ui
