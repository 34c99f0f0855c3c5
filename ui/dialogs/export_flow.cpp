#include "ui/dialogs/export_flow.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "core/base/failure.h"
#include "core/base/phrase.h"
#include "core/exchange/readings_csv.h"
#include "core/session/row_fields.h"
#include "ui/charts/plotting/chart_files.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/export_answers.h"
#include "ui/dialogs/in_background.h"
#include "ui/dialogs/written_file.h"
#include "ui/document/session_document.h"
#include "ui/jobs/failed_job.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

bool hasRows(const Session& session) {
  return std::ranges::any_of(session.positions, [](const Position& position) {
    return !std::ranges::all_of(position.readings, isBlank);
  });
}

}  // namespace

ExportFlow::ExportFlow(const SessionDocument& document, Dialogs& dialogs, QObject* parent)
    : QObject(parent), m_document(document), m_dialogs(dialogs) {}

bool ExportFlow::exportReadings() {
  return exportAnswer(tr("Export readings"), QStringLiteral("readings"), QStringLiteral("csv"),
                      [](const Session& session, const std::string&) -> Result<std::string> {
                        if (!hasRows(session))
                          return Problem{Phrase::of(
                              "there are no readings to export; enter the readings of the axis positions")};
                        return readingsCsv(session);
                      });
}

bool ExportFlow::exportResiduals() {
  return exportAnswer(tr("Export residuals"), QStringLiteral("residuals"), QStringLiteral("csv"),
                      residualsAnswer);
}

bool ExportFlow::exportResult() {
  return exportAnswer(tr("Export result"), QStringLiteral("result"), QStringLiteral("json"), resultAnswer);
}

bool ExportFlow::exportGap() {
  return exportAnswer(tr("Export gap"), QStringLiteral("gap"), QStringLiteral("json"), gapAnswer);
}

bool ExportFlow::exportBudget() {
  return exportAnswer(tr("Export budget"), QStringLiteral("budget"), QStringLiteral("csv"), budgetAnswer);
}

bool ExportFlow::saveChart(const ChartFile& file) {
  return writeTo(tr("Save chart"), file.chart, file.suffix, file.bytes.toStdString());
}

bool ExportFlow::exportAnswer(const QString& title, const QString& what, const QString& suffix,
                              const Answer& answer) {
  emit commitWanted();
  const Session session = m_document.session();
  const std::string name = session.title.empty() ? m_document.displayName().toStdString() : session.title;
  std::optional<Result<std::string>> made;
  const auto failure = failureOf([&] {
    made = inBackground<Result<std::string>>(
        *m_dialogs.busy(tr("Computing what is exported…")),
        [session, name, answer](const std::stop_token&) { return answer(session, name); });
  });
  if (failure) {
    m_dialogs.showProblem(title, qText(reportFailure({PHRASE_LATER("Phrase", "export"), *failure, session})));
    return false;
  }
  if (!made) return false;
  if (!*made) {
    m_dialogs.showProblem(
        title, tr("There is nothing to export yet.\n\n%1").arg(visibleLine(made->problem().text())));
    return false;
  }
  return writeTo(title, what, suffix, **made);
}

bool ExportFlow::writeTo(const QString& title, const QString& what, const QString& suffix,
                         const std::string& bytes) {
  if (bytes.empty()) {
    m_dialogs.showProblem(title,
                          visibleLine(Phrase::of("the picture cannot be made: make the window smaller")));
    return false;
  }
  const auto path = writeToChosenPath(m_dialogs, title, suggestedPath(what, suffix), suffix, bytes);
  if (path) emit remark(tr("Written to %1").arg(QDir::toNativeSeparators(*path)));
  return path.has_value();
}

/// A path in the session's folder, with the session's name followed by `what`.
QString ExportFlow::suggestedPath(const QString& what, const QString& suffix) const {
  const QFileInfo file(m_document.path());
  const QString name = m_document.path().isEmpty() ? m_document.displayName() : file.completeBaseName();
  const QDir folder = m_document.path().isEmpty() ? QDir::home() : file.absoluteDir();
  return folder.filePath(QStringLiteral("%1-%2.%3").arg(name, what, suffix));
}

}  // namespace alidade::ui
