#include "ui/jobs/evaluation.h"

#include <utility>

#include "core/base/failure.h"
#include "core/base/threads.h"
#include "core/wording/journal.h"
#include "ui/charts/arc/arc_picture.h"
#include "ui/charts/residuals/residual_picture.h"

namespace alidade::ui {

namespace {

/// Rigorously and as published, at once where there are many rows.
void fit(Evaluation& evaluation, const std::stop_token& stop) {
  const Measurement& measurement = *evaluation.examined.measurement;
  doAll(threadsFor(measurement.rows), {[&] { evaluation.fit = fitSession(measurement); },
                                       [&] {
                                         if (stop.stop_requested()) return;
                                         evaluation.published = fitSessionAsPublished(measurement);
                                         evaluation.twoFaces = compareFaces(measurement);
                                       }});
}

void draw(Evaluation& evaluation) {
  doAll(
      threadsFor(evaluation.examined.measurement ? evaluation.examined.measurement->rows : 0),
      {[&] { evaluation.arcs = std::make_shared<const ArcPicture>(arcPicture(evaluation)); },
       [&] { evaluation.residuals = std::make_shared<const ResidualPicture>(residualPicture(evaluation)); }});
}

}  // namespace

Evaluation evaluateFit(Session session, const std::stop_token& stop) {
  Evaluation evaluation;
  evaluation.session = std::move(session);
  if (stop.stop_requested()) return evaluation;
  evaluation.examined = examine(evaluation.session);
  if (stop.stop_requested()) return evaluation;
  if (evaluation.examined.measurement) fit(evaluation, stop);
  if (stop.stop_requested()) return evaluation;
  evaluation.isSearched = evaluation.fit.arcs.empty() && evaluation.session.journal.empty();
  evaluation.guide = guideOf(evaluation);
  evaluation.next = nextReadings(
      evaluation.session, evaluation.examined.measurement ? &*evaluation.examined.measurement : nullptr,
      evaluation.fit, evaluation.guide.get());
  draw(evaluation);
  return evaluation;
}

Evaluation withSuspects(Evaluation evaluation, const std::stop_token& stop) {
  if (std::exchange(evaluation.isSearched, true)) return evaluation;
  if (!evaluation.fit.arcs.empty())
    evaluation.suspects =
        findSuspects(evaluation.session, *evaluation.examined.measurement, evaluation.fit, {}, stop);
  if (evaluation.guide && !evaluation.suspects.empty()) evaluation.guide = guideOf(evaluation);
  if (!stop.stop_requested()) evaluation.journal = journalSummary(evaluation.session);
  return evaluation;
}

Evaluation failedEvaluation(Session session, const std::string& failure) {
  Evaluation evaluation;
  evaluation.session = std::move(session);
  const bool isExamined = !failureOf([&] { evaluation.examined = examine(evaluation.session); });
  if (!isExamined) evaluation.examined.problems.clear();
  evaluation.examined.measurement.reset();
  evaluation.failure = failure;
  evaluation.journal = journalSummary(evaluation.session);
  return evaluation;
}

Evaluation withoutSuspects(Evaluation evaluation, const std::string& failure) {
  evaluation.isSearched = true;
  evaluation.searchFailure = failure;
  evaluation.journal = journalSummary(evaluation.session);
  return evaluation;
}

Evaluation evaluate(Session session) {
  return withSuspects(evaluateFit(std::move(session)));
}

}  // namespace alidade::ui
