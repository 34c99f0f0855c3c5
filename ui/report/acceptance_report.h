#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QImage>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>

#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/base/result.h"
#include "core/series/history/device_history.h"
#include "core/signature/signature.h"
#include "ui/jobs/gap.h"
#include "ui/report/report_contents.h"
#include "ui/report/report_paper.h"

class QPagedPaintDevice;

namespace alidade::ui {

/// The session file a report speaks of.
struct ReportSource {
  QString fileName;   ///< as shown at the foot of each page; empty: never saved
  QByteArray sha256;  ///< the digest of the file's bytes, 32 bytes as QCryptographicHash gives them
  bool saved = true;  ///< false: the session has changes the file lacks, or the file those that it lacks;
                      ///< `sha256` is then not used, and the digest of the session as it would be written
                      ///< is printed and called so
  QStringList paths = {};  ///< the session's files, which no report may replace
  QByteArray bytes = {};   ///< of the file, where `saved`, to be attached
};

struct ReportOptions {
  QDateTime date = QDateTime::currentDateTime();  ///< printed on each page
  ReportContents contents = {};
  ReportPaper paper = {};
  QImage logo = {};                                   ///< of the laboratory; null: none
  QString language = {};                              ///< id of a `LanguageInfo`; empty: that of the window
  bool hasSession = true;                             ///< attaches session and results to the file
  std::optional<MonteCarlo> simulated = {};           ///< of the same evaluation: told beside the budget
  std::shared_ptr<const DeviceHistory> history = {};  ///< of the session's device; null: none is told
  /// Of the same evaluation, whose sentences were made in the same language; null: it is assessed here.
  std::shared_ptr<const Gap> gap = {};
  std::optional<Signer> signer = {};  ///< signs the file, its signature beside it (`signaturePath`)
  /// Asked often while the report is written, with the share that is done; false stops it, which is then the
  /// reason why there is none. It is asked in the window's language.
  std::function<bool(double done)> goesOn = {};
};

/// Writes the acceptance report, a PDF/A-3b of vectors and embedded fonts, with the session's file and, where
/// there are any, its results (results.json) attached: result and verdict, what the diagnosis of the gap
/// says, both plots, every reading, as far as that is not left out. It is also written where there is no
/// result; then it says why and carries no verdict. The file is replaced only when all is written, and never
/// one of `source`. The same report of the same date has the same bytes. Answers with the path, or says why
/// it could not be written. Needs a QApplication, on any platform plugin, and its thread.
Result<QString> writeAcceptanceReport(const Evaluation& evaluation, const ReportSource& source,
                                      const QString& outPath, const ReportOptions& options = {});

/// The bytes of that file instead.
Result<std::string> acceptanceReportPdf(const Evaluation& evaluation, const ReportSource& source,
                                        const ReportOptions& options = {});

/// Writes the bytes, with the signature beside them where there is a signer: both files or none, and neither
/// over one of `source` or of the files that the signer was loaded from.
std::optional<Problem> writeSigned(const QString& path, const std::string& bytes,
                                   const std::optional<Signer>& signer, const ReportSource& source);

/// Paints the same pages on a device that is painted on from corner to corner, on whatever paper it has.
/// False: it could not, or was stopped.
bool paintAcceptanceReport(QPagedPaintDevice& device, const Evaluation& evaluation,
                           const ReportSource& source, const ReportOptions& options);

/// As a document of that report is named: "Acceptance report: Guideway 7".
QString reportTitle(const Evaluation& evaluation, const ReportSource& source);

}  // namespace alidade::ui
