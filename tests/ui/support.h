#pragma once

#include <QKeySequence>
#include <QString>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "ui/dialogs/dialogs.h"

class QWidget;

namespace alidade::ui {

class ImportPage;
class MainWindow;
class ReadingsTable;

/// Returns scripted answers instead of asking, and records what was shown.
class ScriptedDialogs : public Dialogs {
 public:
  SaveAnswer saveAnswer = SaveAnswer::Cancel;
  std::vector<SaveAnswer> saveAnswers;  ///< for successive questions; afterwards `saveAnswer`
  QString openPath, savePath, reportPath, exportPath, recordPath, protocolPath;
  std::optional<SightingProtocol> protocol = {};  ///< the answer of the form
  QString exportSuggested;                        ///< the last suggestion
  QString importPath;                             ///< several: one per line
  QString seriesFolder;                           ///< folder of a series; empty: cancelled
  QStringList sessionPaths;                       ///< likewise
  std::function<void(ImportPage&)> onImport;      ///< acts on the page before it is accepted
  int importsAsked = 0;
  int saveQuestions = 0;
  Unsaved leaving;  ///< of the last of these questions
  bool discardOther = false;
  bool deletePosition = true;
  QStringList deletionsAsked;
  QStringList othersAsked;  ///< sessions whose loss by undo or redo was asked about
  bool exportAnyway = false;
  QList<int> unusableEntries;  ///< counts from each question before a report
  bool writeAnyway = true;
  QList<QStringList> emptyFields;               ///< from each question before a report
  std::optional<ReportChoice> reportChoice;     ///< absent: the remembered choice
  std::vector<ReportQuestion> reportQuestions;  ///< recorded questions
  std::optional<ReportPaper> paper;             ///< absent: cancelled
  QString printPath;                            ///< path of the printed PDF; empty: cancelled
  QStringList previewPaths;                     ///< likewise for each preview
  std::vector<PreviewAnswer> previewAnswers;    ///< for successive previews; afterwards: closed
  int previews = 0;
  QString sealedBy;           ///< the answer to who seals
  QString sealSuggested;      ///< the recorded suggestion
  std::optional<QFont> font;  ///< absent: cancelled
  QStringList problems;
  bool goOn = false;      ///< whether to continue with a file that is open elsewhere
  QStringList elsewhere;  ///< names of such files in the questions
  ChangedFileAnswer changedFileAnswer = ChangedFileAnswer::Cancel;
  QList<ChangedFile> changedFiles;           ///< recorded questions
  std::vector<RecoveryAnswer> recoveries;    ///< for successive questions; afterwards: later
  std::vector<QList<RecoveryOffer>> offers;  ///< recorded questions

  bool askOpenElsewhere(const QString& name, const QString&) override {
    elsewhere.append(name);
    return goOn;
  }
  ChangedFileAnswer askChangedFile(const ChangedFile& file) override {
    changedFiles.append(file);
    return changedFileAnswer;
  }
  RecoveryAnswer askRecovery(const QList<RecoveryOffer>& left) override {
    offers.push_back(left);
    return offers.size() <= recoveries.size() ? recoveries[offers.size() - 1] : RecoveryAnswer();
  }
  SaveAnswer askLeave(const Unsaved& unsaved) override {
    ++saveQuestions;
    leaving = unsaved;
    const auto asked = static_cast<std::size_t>(saveQuestions);
    return asked <= saveAnswers.size() ? saveAnswers[asked - 1] : saveAnswer;
  }
  bool askDiscardOther(const QString& name, Way way) override {
    othersAsked.append(QLatin1String(way == Way::Undo ? "undo to " : "redo to ") + name);
    return discardOther;
  }
  bool askDeletePosition(const QString& name, std::size_t sightings) override {
    deletionsAsked.append(QStringLiteral("%1: %2").arg(name).arg(sightings));
    return deletePosition;
  }
  QString askOpenPath(const QString&) override { return openPath; }
  QStringList askImportPaths(const QString&) override {
    return importPath.isEmpty() ? QStringList() : importPath.split(u'\n');
  }
  QString askFolder(const QString&, const QString&) override { return seriesFolder; }
  QStringList askSessionPaths(const QString&) override { return sessionPaths; }
  std::optional<ImportDecision> askImport(ImportRequest request) override;
  QString askRecordPath(const QString&) override { return recordPath; }
  std::optional<OwnEffect> askOwnEffect(const Session&, const OwnEffect& asked) override {
    effectAsked = asked;
    return effectAnswer;
  }
  std::optional<OwnEffect> effectAsked, effectAnswer;
  QString askProtocolPath(const QString&) override { return protocolPath; }
  std::optional<SightingProtocol> askProtocol(const SightingProtocol&, CircleUnit) override {
    return protocol;
  }
  QString askSavePath(const QString&) override { return savePath; }
  QString askReportPath(const QString&) override { return reportPath; }
  QString askExportPath(const QString&, const QString& suggestion, const QString&) override {
    exportSuggested = suggestion;
    return exportPath;
  }
  std::optional<ReportChoice> askReport(const ReportQuestion& question) override {
    reportQuestions.push_back(question);
    if (question.unusable > 0) unusableEntries.append(question.unusable);
    if (!question.emptyFields.isEmpty()) emptyFields.append(question.emptyFields);
    if ((question.unusable > 0 && !exportAnyway) || !writeAnyway) return {};
    return reportChoice.value_or(question.choice);
  }
  bool askPaper(ReportPaper& asked) override {
    asked = paper.value_or(asked);
    return paper.has_value();
  }
  bool askPrinter(QPrinter& printer, const QString& /*title*/) override {
    return printsTo(printer, printPath);
  }
  PreviewAnswer showPreview(QPrinter& printer, const std::function<void(QPrinter&)>& paint,
                            const PreviewChange& change) override;
  QString askSeal(const QString& suggestion) override {
    sealSuggested = suggestion;
    return sealedBy;
  }
  bool askPreferences() override { return false; }
  std::optional<QFont> askFont(const QFont&) override { return font; }
  void showProblem(const QString&, const QString& text) override { problems.append(text); }

 private:
  static bool printsTo(QPrinter& printer, const QString& path);
};

/// A visible window with scripted dialogs. Removes its files.
struct OpenWindow {
  OpenWindow();
  ~OpenWindow();

  ScriptedDialogs* dialogs;  ///< the window's
  std::unique_ptr<MainWindow> window;

  MainWindow* operator->() { return window.get(); }
  /// Waits until the newest session is evaluated and shown.
  void waitUntilIdle();
};

/// The paper's table, and the file it is in.
Session paperSession();
/// The same as file text, with these effects estimated in the model.
std::string paperTextWithEffects(const std::vector<std::string>& effects);
QString samplePath(const QString& name);
/// A simulated session without errors, with positions at these axis angles in the order read, and a
/// tolerance.
Session sessionTakenAt(const std::vector<int>& axes);

/// A simulated session with an outward and a return run in both faces.
Session sessionInTwoFaces();

/// Types `text` and ends it with `key`, into the focused widget or a cell editor.
void typeInto(QWidget& widget, const QString& text, Qt::Key key = Qt::Key_Return);

/// Processes events until `done`, for at most a minute, which allows for sanitizers and busy machines. False:
/// timeout.
bool waitFor(const std::function<bool()>& done);

}  // namespace alidade::ui
