#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>

#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/base/result.h"
#include "ui/jobs/gap.h"

namespace alidade::ui {

/// The session file a report speaks of.
struct ReportSource {
  QString fileName;   ///< as shown at the foot of each page; empty: never saved
  QByteArray sha256;  ///< the digest of the file's bytes, 32 bytes as QCryptographicHash gives them
  bool saved = true;  ///< false: the session has changes the file lacks; `sha256` is then not used, and the
                      ///< digest of the session as it would be written is printed and called so
  QStringList paths = {};  ///< the session's files, which no report may replace
};

struct ReportOptions {
  QDateTime date = QDateTime::currentDateTime();  ///< printed on each page
  std::optional<MonteCarlo> simulated = {};       ///< of the same evaluation: told beside the budget
  std::shared_ptr<const Gap> gap = {};            ///< of the same evaluation; null: it is assessed here
  /// Asked often while the report is written, with the share that is done; false stops it, which is then the
  /// reason why there is none.
  std::function<bool(double done)> goesOn = {};
};

/// Writes the acceptance report, an A4 PDF of vectors and embedded fonts (PDF/A-1b): result and verdict, what
/// the diagnosis of the gap says, both plots, every reading. It is also written where there is no result;
/// then it says why and carries no verdict. The file is replaced only when all is written, and never one of
/// `source`. Answers with the path, or says why it could not be written. Needs a QApplication, on any
/// platform plugin, and its thread.
Result<QString> writeAcceptanceReport(const Evaluation& evaluation, const ReportSource& source,
                                      const QString& outPath, const ReportOptions& options = {});

}  // namespace alidade::ui
