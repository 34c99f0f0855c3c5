#include "ui/window/session_jobs.h"

#include <memory>
#include <optional>
#include <utility>

#include "core/evaluation/guide.h"
#include "core/session/session_fields.h"
#include "ui/document/journal_entries.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

namespace {

/// True if the change affects no result.
bool isRemark(const SessionChange& change) {
  return change.kind == SessionChange::Kind::Field &&
         (change.place.field == "journal" || !isOfMeasurement(change.place));
}

}  // namespace

void SessionJobs::start() {
  connect(&m_document, &SessionDocument::changed, this, &SessionJobs::follow);
  connect(&m_fit, &FitJob::evaluated, this, &SessionJobs::show);
  connect(&m_fit, &FitJob::searched, this, &SessionJobs::suspectsChanged);
  connect(&m_gap, &GapJob::assessed, this, &SessionJobs::showGap);
  connect(&m_gap, &GapJob::completed, this, [this](const SharedGap& gap) {
    m_completed = gap;
    emit headlineChanged(headlineOf(*gap));
  });
  m_fit.request(m_document.session());
  emit begun();
}

void SessionJobs::follow(const SessionChange& change) {
  if (change.kind == SessionChange::Kind::Everything) {
    m_gap.setWithReference(false);
    m_completed.reset();
    clearGap();
  } else if (!isRemark(change)) {
    ageGap();
  }
  m_gap.cancel();
  m_fit.request(m_document.session());
  emit begun();
}

void SessionJobs::show(const SharedEvaluation& evaluation) {
  m_shown = evaluation;
  const Guide* guide = evaluation->guide.get();
  m_document.setChosenSighting(guide && guide->choice ? std::optional(guide->choice->next) : std::nullopt);
  emit suspectsChanged(evaluation);
  emit evaluated(evaluation);
  if (showGapAgain(evaluation)) return;
  showProvisional();
  m_gap.request(evaluation);
}

/// If the measurement is unchanged, as after an undo, shows the last diagnosis again and returns true.
bool SessionJobs::showGapAgain(const SharedEvaluation& evaluation) {
  if (!m_completed || !isSameMeasurement(m_completed->evaluation->session, evaluation->session)) return false;
  Gap gap = *m_completed;
  gap.evaluation = evaluation;
  m_completed = std::make_shared<const Gap>(std::move(gap));
  showGap(m_completed);
  return true;
}

void SessionJobs::showProvisional() {
  if (m_shown) emit headlineChanged(headlineOf(*m_shown));
}

void SessionJobs::showGap(const SharedGap& gap) {
  emit headlineChanged(headlineOf(*gap));
  emit gapChanged(gap);
  m_isGapOld = false;
}

void SessionJobs::ageGap() {
  if (std::exchange(m_isGapOld, true)) return;
  emit gapAged();
  showProvisional();
}

void SessionJobs::clearGap() {
  emit gapCleared();
  showProvisional();
  m_isGapOld = false;
}

void SessionJobs::setWithReference(bool wanted) {
  if (!m_gap.setWithReference(wanted)) return;
  m_completed.reset();
  ageGap();
  if (m_fit.isFitting()) return;  // the result of the fit will be diagnosed
  m_gap.request(m_shown);
  emit begun();
}

void SessionJobs::stop() {
  if (m_fit.isFitting() || !m_shown) return;
  if (m_fit.isSearching()) {
    m_fit.stopSearch();
    emit searchStopped();
  }
  if (m_gap.isIdle()) return;
  m_gap.cancel();
  showGap(std::make_shared<const Gap>(noGap(m_shown, Absence::Stopped)));
}

}  // namespace alidade::ui
