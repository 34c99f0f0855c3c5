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
#include "core/evaluation/gap.h"
#include "core/series/history/device_history.h"
#include "core/signature/signature.h"
#include "ui/report/report_contents.h"
#include "ui/report/report_paper.h"

class QPagedPaintDevice;

namespace alidade::ui {

/// The session file named in a report.
struct ReportSource {
  QString fileName;        ///< name of the file, shown at the foot of each page; empty: never saved
  QByteArray sha256;       ///< SHA-256 digest of the file's bytes, 32 bytes
  bool saved = true;       ///< false: session and file differ; instead of `sha256` the report then states
                           ///< the digest of the unsaved session's content, with a label
  QStringList paths = {};  ///< the session's files, which no report may replace
  QByteArray bytes = {};   ///< bytes of the file to attach, if `saved`

  /// The bytes of the file; of the unsaved session in the form in which it would be saved.
  std::string bytesOf(const Session& session) const;
};

struct ReportOptions {
  QDateTime date = QDateTime::currentDateTime();  ///< printed on each page
  ReportContents contents = {};
  ReportPaper paper = {};
  QImage logo = {};        ///< logo of the laboratory; null: none
  QString language = {};   ///< id of a `LanguageInfo`; empty: the window's language
  bool hasSession = true;  ///< true: session and results are attached to the file
  std::optional<MonteCarlo> simulated =
      {};  ///< a Monte Carlo check of the same evaluation, reported with the budget
  std::shared_ptr<const DeviceHistory> history = {};  ///< history of the session's device; null: not included
  /// The gap of the same evaluation, with sentences in the report's language; null: assessed by the report.
  std::shared_ptr<const Gap> gap = {};
  std::optional<Signer> signer = {};  ///< signs the file; the signature goes to `signaturePath`
  /// Called often while the report is written, with the share of the work done, 0 to 1, in the window's
  /// language. Returning false stops the report, which then fails.
  std::function<bool(double done)> goesOn = {};
};

/// Writes the acceptance report, a PDF/A-3b of vectors and embedded fonts, with the session's file and any
/// results (results.json) attached. The report contains result and verdict; `contents` can leave out the
/// diagnosis of the gap, both plots and the readings.
/// Without a result the report gives the reason and no verdict. The old file is replaced only after complete
/// writing; files of `source` are never replaced. Equal report and date give equal bytes. Returns the path,
/// or why writing failed. Call on the thread of the QApplication, which may use any platform plugin.
Result<QString> writeAcceptanceReport(const Evaluation& evaluation, const ReportSource& source,
                                      const QString& outPath, const ReportOptions& options = {});

/// Returns the acceptance report as bytes, without writing a file.
Result<std::string> acceptanceReportPdf(const Evaluation& evaluation, const ReportSource& source,
                                        const ReportOptions& options = {});

/// Writes the bytes, and with a signer the signature in a second file: both files or none. Never replaces a
/// file of `source` or of the signer.
std::optional<Problem> writeSigned(const QString& path, const std::string& bytes,
                                   const std::optional<Signer>& signer, const ReportSource& source);

/// Paints the report on a full-page device of any paper size. Returns false if it failed or was stopped.
bool paintAcceptanceReport(QPagedPaintDevice& device, const Evaluation& evaluation,
                           const ReportSource& source, const ReportOptions& options);

/// The document title of the report: "Acceptance report: Guideway 7".
QString reportTitle(const Evaluation& evaluation, const ReportSource& source);

}  // namespace alidade::ui
