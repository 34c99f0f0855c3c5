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

/// Writes what other programs read of the session at work: readings, residuals, result, gap and budget, and
/// pictures of charts. What is answered is computed anew of the session as it is. Each is true where it was
/// written, false where it failed (the user was told why) or was cancelled.
class ExportFlow : public QObject {
  Q_OBJECT

 public:
  ExportFlow(const SessionDocument& document, Dialogs& dialogs, QObject* parent = nullptr);

  bool exportReadings();   ///< a table that can be imported again (`readingsCsv`)
  bool exportResiduals();  ///< `residualsCsv`
  bool exportResult();     ///< the document of `alidade-cli fit --json`
  bool exportGap();        ///< that of `alidade-cli diagnose --json`
  bool exportBudget();     ///< `budgetCsv`
  bool saveChart(const ChartFile& file);

 signals:
  void commitWanted();  ///< what is half typed belongs into the session before it is used
  void remark(const QString& text);

 private:
  /// Of a session and its name; the sentence says why there is nothing to write.
  using Answer = std::function<Result<std::string>(const Session&, const std::string& name)>;

  bool exportAnswer(const QString& title, const QString& what, const QString& suffix, const Answer& answer);
  bool writeTo(const QString& title, const QString& what, const QString& suffix, const std::string& bytes);
  QString suggestedPath(const QString& what, const QString& suffix) const;

  const SessionDocument& m_document;
  Dialogs& m_dialogs;
};

}  // namespace alidade::ui
