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

/// Makes the report of the current session as a PDF, on paper or as a preview, after asking for its contents.
class ReportFlow : public QObject {
  Q_OBJECT

 public:
  ReportFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent = nullptr);

  /// Each function returns true on success, false if it failed (the user was told why) or was cancelled.
  /// `suggestion` is the initial path.
  bool exportPdf(const QString& suggestion);
  /// The digital calibration certificate with the report attached; first lists the entries that the
  /// certificate will call not stated.
  bool exportCertificate(const QString& suggestion);
  bool print();
  bool preview(const QString& suggestion);
  /// Stores a check of the uncertainty, for reports of its session.
  void setBudgetCheck(const SharedBudgetCheck& check) { m_check = check; }

 signals:
  void commitWanted();               ///< unfinished entries must be committed before the session is used
  void remark(const QString& text);  ///< for the status line

 private:
  bool guarded(const QString& title, const std::function<bool()>& work);
  SharedGap diagnosed(const QString& language = {}) const;
  /// Returns `gap` if `language` is the window's language, in which the sentences of `gap` are; otherwise
  /// diagnoses again. Null: the user stopped the diagnosis.
  SharedGap inLanguage(const QString& language, const SharedGap& gap);
  /// Asks for the user's choice for the report of `gap` and stores the choice; absent: cancelled. `lacks`:
  /// the statements that a certificate will lack.
  std::optional<ReportChoice> ask(const Gap& gap, ReportQuestion::Way way,
                                  const std::optional<QStringList>& lacks = {});
  /// Options for a report of `gap`, with the logo; absent: the logo is unusable and the user was told.
  std::optional<ReportOptions> optionsFor(const SharedGap& gap, const ReportChoice& choice);
  bool exportOf(const SharedGap& gap, const QString& suggestion);
  bool certificateOf(const SharedGap& gap, const QString& suggestion);
  bool printOf(const SharedGap& gap);
  bool previewOf(const SharedGap& gap, const QString& suggestion);

  SessionDocument& m_document;
  Dialogs& m_dialogs;
  ReportSource source() const;
  /// The history of the session's device from a folder of sessions; null: the folder has no session of the
  /// device, or the user stopped the search.
  std::shared_ptr<const DeviceHistory> historyIn(const QString& folder);

  SharedBudgetCheck m_check;
  struct LastHistory {
    QString folder;
    std::shared_ptr<const DeviceHistory> history;
  } m_lastHistory;  ///< last result of `historyIn`, kept while a report is being made
  struct Translated {
    QString language;
    SharedGap of, gap;
  } m_translated;  ///< last result of `inLanguage`, kept while a report is being made
};

/// The file named in a report of the document. Its bytes and their hash are read unless the session has
/// unsaved changes; `saved` is true if the file equals the session.
ReportSource reportSource(const SessionDocument& document);

}  // namespace alidade::ui
