#pragma once

#include <QObject>
#include <functional>
#include <string>

#include "core/base/result.h"

namespace alidade {
struct Session;
}

namespace alidade::ui {

class Dialogs;
class SessionDocument;
struct ChartFile;

/// Exports the current session for other programs: readings, residuals, result, gap, budget, and pictures of
/// charts. Results are always recomputed. Each function returns true on success, false if it failed (the user
/// was told why) or was cancelled.
class ExportFlow : public QObject {
  Q_OBJECT

 public:
  ExportFlow(const SessionDocument& document, Dialogs& dialogs, QObject* parent = nullptr);

  bool exportReadings();   ///< a table that can be imported again (`readingsCsv`)
  bool exportResiduals();  ///< `residualsCsv`
  bool exportResult();     ///< the document of `alidade-cli fit --json`
  bool exportGap();        ///< the document of `alidade-cli diagnose --json`
  bool exportBudget();     ///< `budgetCsv`
  bool saveChart(const ChartFile& file);

 signals:
  void commitWanted();  ///< unfinished entries must be committed before the session is used
  void remark(const QString& text);

 private:
  /// Makes the bytes of the file from a session and its name; the problem says why there is nothing to write.
  using Answer = std::function<Result<std::string>(const Session&, const std::string& name)>;

  bool exportAnswer(const QString& title, const QString& what, const QString& suffix, const Answer& answer);
  bool writeTo(const QString& title, const QString& what, const QString& suffix, const std::string& bytes);
  QString suggestedPath(const QString& what, const QString& suffix) const;

  const SessionDocument& m_document;
  Dialogs& m_dialogs;
};

}  // namespace alidade::ui
