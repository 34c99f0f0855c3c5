#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "ui/dialogs/report_dialog.h"
#include "ui/jobs/gap_job.h"
#include "ui/jobs/simulation_job.h"
#include "ui/report/acceptance_report.h"

namespace alidade::ui {

class Dialogs;
class SessionDocument;

/// From the session at work to its report: as a PDF, on paper, or to look at, with the one question before
/// it.
class ReportFlow : public QObject {
  Q_OBJECT

 public:
  ReportFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent = nullptr);

  /// Each is true where it was done, false where it failed (the user was told why) or was cancelled.
  /// `suggestion` is a path to begin with.
  bool exportPdf(const QString& suggestion);
  /// The digital calibration certificate with the report in it; what it will call not stated is asked about
  /// first.
  bool exportCertificate(const QString& suggestion);
  bool print();
  bool preview(const QString& suggestion);
  void setUpPage();  ///< for reports to come
  /// A check of the uncertainty, for reports of the session that it is of.
  void setBudgetCheck(const SharedBudgetCheck& check) { m_check = check; }

 signals:
  void commitWanted();               ///< what is half typed belongs into the session before it is used
  void remark(const QString& text);  ///< for the status line

 private:
  bool guarded(const QString& title, const std::function<bool()>& work);
  SharedGap diagnosed(const QString& language = {}) const;
  /// The same as `gap`, whose sentences were made for the window, in the language of the report: diagnosed
  /// anew where that is another. Null: the user stopped it.
  SharedGap spokenIn(const QString& language, const SharedGap& gap);
  /// What is chosen for the report of `gap`, and remembered; absent: cancelled.
  /// `lacks`: what will be missing, where that is not what a report lacks.
  std::optional<ReportChoice> ask(const Gap& gap, ReportQuestion::Way way,
                                  const std::optional<QStringList>& lacks = {});
  /// For a report of `gap`, with the logo; absent: it cannot be used, which was told.
  std::optional<ReportOptions> optionsFor(const SharedGap& gap, const ReportChoice& choice);
  bool exportOf(const SharedGap& gap, const QString& suggestion);
  bool certificateOf(const SharedGap& gap, const QString& suggestion);
  bool printOf(const SharedGap& gap);
  bool previewOf(const SharedGap& gap, const QString& suggestion);

  SessionDocument& m_document;
  Dialogs& m_dialogs;
  /// Of the device of the session at work, by the sessions of a folder; null: none of them is of it, or the
  /// user stopped it.
  ReportSource source() const;
  std::shared_ptr<const DeviceHistory> historyIn(const QString& folder);

  SharedBudgetCheck m_check;
  struct Told {
    QString folder;
    std::shared_ptr<const DeviceHistory> history;
  } m_told;  ///< what `historyIn` made last, likewise as long as a report is at work
  struct Spoken {
    QString language;
    SharedGap of, gap;
  } m_spoken;  ///< what `spokenIn` made last, as long as a report is at work
};

}  // namespace alidade::ui
