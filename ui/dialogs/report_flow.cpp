#include "ui/dialogs/report_flow.h"

#include <QDir>
#include <QFileInfo>
#include <QPrinter>
#include <algorithm>

#include "core/base/failure.h"
#include "core/base/phrase.h"
#include "core/evaluation/evaluation.h"
#include "core/session/hindrance.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/in_background.h"
#include "ui/document/session_document.h"
#include "ui/jobs/failed_job.h"
#include "ui/jobs/series_job.h"
#include "ui/language/languages.h"
#include "ui/report/certificate.h"
#include "ui/report/empty_fields.h"
#include "ui/report/report_choice.h"
#include "ui/report/report_logo.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

/// Uses the full page without printer margins, like a PDF.
void setPaper(QPrinter& printer, const ReportPaper& paper, const QString& title) {
  printer.setDocName(title);
  printer.setPageLayout(paper.layout());
}

}  // namespace

ReportFlow::ReportFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent)
    : QObject(parent), m_document(document), m_dialogs(dialogs) {}

bool ReportFlow::guarded(const QString& title, const std::function<bool()>& work) {
  emit commitWanted();
  bool isDone = false;
  const auto failure = failureOf([&] { isDone = work(); });
  m_translated = {};
  m_lastHistory = {};
  if (failure)
    m_dialogs.showProblem(
        title,
        qText(reportFailure({PHRASE_LATER("Phrase", "acceptance report"), *failure, m_document.session()})));
  return isDone;
}

bool ReportFlow::exportPdf(const QString& suggestion) {
  return guarded(tr("Export acceptance report"), [&] {
    const SharedGap gap = diagnosed();
    return gap && exportOf(gap, suggestion);
  });
}

bool ReportFlow::exportCertificate(const QString& suggestion) {
  return guarded(tr("Export calibration certificate"), [&] {
    const SharedGap gap = diagnosed();
    return gap && certificateOf(gap, suggestion);
  });
}

bool ReportFlow::print() {
  return guarded(tr("Print acceptance report"), [&] {
    const SharedGap gap = diagnosed();
    return gap && printOf(gap);
  });
}

bool ReportFlow::preview(const QString& suggestion) {
  return guarded(tr("Print preview"), [&] {
    const SharedGap gap = diagnosed();
    return gap && previewOf(gap, suggestion);
  });
}

/// The report must not replace any file read for the window.
ReportSource ReportFlow::source() const {
  ReportSource source = reportSource(m_document);
  source.paths += m_dialogs.readFiles();
  return source;
}

std::optional<ReportChoice> ReportFlow::ask(const Gap& gap, ReportQuestion::Way way,
                                            const std::optional<QStringList>& lacks) {
  const Evaluation& evaluation = *gap.evaluation;
  ReportQuestion question{
      .way = way,
      .choice = rememberedReportChoice(),
      .emptyFields = lacks ? *lacks : emptyReportFields(evaluation.session),
      .isCertificate = lacks.has_value(),
      .unusable = static_cast<int>(hindrances(evaluation.session, evaluation.examined.problems).size())};
  for (const ReportPartInfo& info : allReportParts()) {
    if (isThere(info.part, gap)) question.there.push_back(info.part);
    if (isMandatory(info.part, gap)) question.mandatory.push_back(info.part);
  }
  const std::optional<ReportChoice> choice = m_dialogs.askReport(question);
  if (choice) rememberReportChoice(*choice);
  return choice;
}

std::optional<ReportOptions> ReportFlow::optionsFor(const SharedGap& gap, const ReportChoice& choice) {
  ReportOptions options;
  options.contents = choice.contents;
  options.paper = choice.paper;
  options.language = choice.language;
  options.hasSession = choice.hasSession;
  options.gap = gap;
  if (!choice.seriesFolder.isEmpty()) options.history = historyIn(choice.seriesFolder);
  if (m_check && m_check->isOf(m_document.session())) options.simulated = m_check->simulated;
  if (choice.logoPath.isEmpty()) return options;
  const Result<QImage> logo = readLogo(choice.logoPath);
  if (!logo) {
    m_dialogs.showProblem(tr("Acceptance report"),
                          tr("%1. Choose another logo in the dialog of the report, or none.")
                              .arg(visibleLine(logo.problem().what)));
    return {};
  }
  options.logo = *logo;
  return options;
}

std::shared_ptr<const DeviceHistory> ReportFlow::historyIn(const QString& folder) {
  if (m_lastHistory.folder == folder) return m_lastHistory.history;
  const auto busy = m_dialogs.busy(tr("Reading the history of the device…"));
  const auto series =
      inBackground<Series>(*busy, [paths = sessionPathsIn({folder})](const std::stop_token& stop) {
        return readSeries({}, paths, stop);
      });
  m_lastHistory = {folder, nullptr};
  if (!series) return nullptr;
  const Device& device = m_document.session().device;
  const auto found = std::ranges::find_if(series->devices, [&](const DeviceHistory& one) {
    return device.serial.empty() ? one.serial.empty() && one.name == device.name
                                 : one.serial == device.serial;
  });
  if (found == series->devices.end())
    emit remark(tr("The folder of the history holds no session of this device: the report has no history."));
  else
    m_lastHistory.history = std::make_shared<const DeviceHistory>(*found);
  return m_lastHistory.history;
}

bool ReportFlow::exportOf(const SharedGap& gap, const QString& suggestion) {
  const QString title = tr("Export acceptance report");
  const auto choice = ask(*gap, ReportQuestion::Way::Export);
  if (!choice) return false;
  const SharedGap translated = inLanguage(choice->language, gap);
  if (!translated) return false;
  auto options = optionsFor(translated, *choice);
  if (!options) return false;
  const QString path = m_dialogs.askReportPath(suggestion);
  if (path.isEmpty()) return false;
  if (const QFileInfo file(path); file.exists() && !file.isFile()) {
    m_dialogs.showProblem(title,
                          tr("“%1” is a folder, pipe or device: choose a file.").arg(visibleLine(path)));
    return false;
  }
  const auto busy = m_dialogs.busy(tr("Writing the report…"));
  bool isStopped = false;
  options->goesOn = [&](double done) {
    isStopped = isStopped || !busy->goesOn(done);
    return !isStopped;
  };
  const Result<QString> written = writeAcceptanceReport(*translated->evaluation, source(), path, *options);
  if (isStopped) {
    emit remark(tr("Stopped: no report was written."));
    return false;
  }
  if (!written) {
    m_dialogs.showProblem(title, visibleLine(written.problem().text()));
    return false;
  }
  emit remark(tr("Report written to %1").arg(QDir::toNativeSeparators(*written)));
  return true;
}

bool ReportFlow::certificateOf(const SharedGap& gap, const QString& suggestion) {
  const QString title = tr("Export calibration certificate");
  ReportOptions bare;
  bare.gap = gap;
  // The dialog asks for country and place. The assumed values serve only to list other missing statements.
  CertificateEntries assumed{.country = QStringLiteral("ZZ"), .performedAt = QStringLiteral("other")};
  assumed.isDraft = true;
  const auto lacking = ui::certificateOf(source(), bare, assumed);
  if (!lacking) {
    m_dialogs.showProblem(title, visibleLine(lacking.problem().text()));
    return false;
  }
  const auto choice = ask(*gap, ReportQuestion::Way::Export, lacking->notStated);
  if (!choice) return false;
  const SharedGap translated = inLanguage(choice->language, gap);
  if (!translated) return false;
  auto options = optionsFor(translated, *choice);
  if (!options) return false;
  if (const auto whole = ui::certificateOf(source(), *options, choice->certificate); !whole) {
    m_dialogs.showProblem(title, visibleLine(whole.problem().text()));
    return false;
  }
  const QString path = m_dialogs.askExportPath(title, suggestion, QStringLiteral("xml"));
  if (path.isEmpty()) return false;
  const auto busy = m_dialogs.busy(tr("Writing the certificate…"));
  bool isStopped = false;
  options->goesOn = [&](double done) {
    isStopped = isStopped || !busy->goesOn(done);
    return !isStopped;
  };
  const auto written = writeCertificate(source(), path, *options, choice->certificate);
  if (isStopped) {
    emit remark(tr("Stopped: no certificate was written."));
    return false;
  }
  if (!written) {
    m_dialogs.showProblem(title, visibleLine(written.problem().text()));
    return false;
  }
  emit remark(tr("Certificate written to %1").arg(QDir::toNativeSeparators(path)));
  return true;
}

bool ReportFlow::printOf(const SharedGap& gap) {
  const auto choice = ask(*gap, ReportQuestion::Way::Print);
  if (!choice) return false;
  const SharedGap translated = inLanguage(choice->language, gap);
  if (!translated) return false;
  auto options = optionsFor(translated, *choice);
  if (!options) return false;
  const ReportSource source = reportSource(m_document);
  QPrinter printer(QPrinter::HighResolution);
  setPaper(printer, choice->paper, reportTitle(*translated->evaluation, source));
  if (!m_dialogs.askPrinter(printer, tr("Print acceptance report"))) return false;
  printer.setFullPage(true);  // a newly chosen printer may have margins of its own
  const auto busy = m_dialogs.busy(tr("Printing the report…"));
  bool isStopped = false;
  options->goesOn = [&](double done) {
    isStopped = isStopped || !busy->goesOn(done);
    return !isStopped;
  };
  const bool isPrinted = paintAcceptanceReport(printer, *translated->evaluation, source, *options);
  if (isStopped) {
    printer.abort();
    emit remark(tr("Stopped: the report may be printed in part."));
  } else if (!isPrinted) {
    m_dialogs.showProblem(tr("Print acceptance report"),
                          tr("Alidade cannot print on “%1”: choose another printer, or export a PDF.")
                              .arg(visibleLine(printer.printerName())));
  } else {
    emit remark(tr("Report sent to the printer"));
  }
  return isPrinted && !isStopped;
}

bool ReportFlow::previewOf(const SharedGap& gap, const QString& suggestion) {
  ReportChoice choice = rememberedReportChoice();
  const ReportSource source = reportSource(m_document);
  QPrinter printer(QPrinter::HighResolution);
  SharedGap shown;
  std::optional<ReportOptions> options;
  const auto prepare = [&] {
    const SharedGap translated = inLanguage(choice.language, gap);
    if (!translated) return false;
    shown = translated;
    options = optionsFor(shown, choice);
    if (!options) {
      choice.logoPath.clear();
      options = optionsFor(shown, choice);
    }
    setPaper(printer, choice.paper, reportTitle(*shown->evaluation, source));
    return true;
  };
  if (!prepare()) return false;
  const auto change = [&](PreviewAnswer what) {
    if (what == PreviewAnswer::Contents)
      choice = ask(*gap, ReportQuestion::Way::Preview).value_or(choice);
    else if (m_dialogs.askPaper(choice.paper))
      rememberReportChoice(choice);
    prepare();
  };
  const auto paint = [&](QPrinter& on) { paintAcceptanceReport(on, *shown->evaluation, source, *options); };
  switch (m_dialogs.showPreview(printer, paint, change)) {
    case PreviewAnswer::Print:
      return printOf(gap);
    case PreviewAnswer::Export:
      return exportOf(gap, suggestion);
    case PreviewAnswer::Close:
    case PreviewAnswer::Contents:
    case PreviewAnswer::Page:
      break;
  }
  return true;
}

SharedGap ReportFlow::inLanguage(const QString& language, const SharedGap& gap) {
  if (language.isEmpty() || language == shownLanguage()) return gap;
  if (m_translated.of != gap || m_translated.language != language || !m_translated.gap)
    m_translated = {language, gap, diagnosed(language)};
  return m_translated.gap;
}

/// Diagnoses the current session, with sentences in `language`; null: the user stopped the diagnosis.
SharedGap ReportFlow::diagnosed(const QString& language) const {
  const auto busy = m_dialogs.busy(tr("Fitting and diagnosing for the report…"));
  const auto gap =
      inBackground<Gap>(*busy, [session = m_document.session(), language](const std::stop_token& stop) {
        const LanguageScope scope(language);
        const auto evaluation =
            std::make_shared<const Evaluation>(withSuspects(evaluateFit(session, stop), stop));
        return stop.stop_requested()
                   ? Gap{.evaluation = evaluation, .diagnosis = {}, .reason = {}, .stages = {}}
                   : withDependences(assessGap(evaluation, stop), stop);
      });
  return gap ? std::make_shared<const Gap>(*gap) : nullptr;
}

}  // namespace alidade::ui
