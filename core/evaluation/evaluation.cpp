#include "core/evaluation/evaluation.h"

#include <utility>

#include "core/wording/findings.h"
#include "core/wording/journal.h"

namespace alidade {

namespace {

void fit(Evaluation& evaluation, const std::stop_token& stop) {
  const Measurement& measurement = *evaluation.examined.measurement;
  evaluation.fit = fitSession(measurement);
  if (stop.stop_requested()) return;
  evaluation.published = fitSessionAsPublished(measurement);
  evaluation.twoFaces = compareFaces(measurement);
}

/// The results that `withSuspects` adds to the fit.
struct Searched {
  std::vector<Suspect> suspects;
  std::string journal;
};

Searched search(const Evaluation& evaluation, const std::stop_token& stop) {
  Searched found;
  const std::optional<Measurement>& measurement = evaluation.examined.measurement;
  if (!evaluation.fit.arcs.empty())
    found.suspects = findSuspects(evaluation.session, *measurement, evaluation.fit, {}, stop);
  if (!stop.stop_requested()) found.journal = journalSummary(evaluation.session);
  return found;
}

void take(Evaluation& evaluation, Searched found) {
  evaluation.isSearched = true;
  evaluation.suspects = std::move(found.suspects);
  evaluation.journal = std::move(found.journal);
  if (evaluation.guide && !evaluation.suspects.empty()) evaluation.guide = guideOf(evaluation);
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
  return evaluation;
}

Evaluation withSuspects(Evaluation evaluation, const std::stop_token& stop) {
  if (!evaluation.isSearched) take(evaluation, search(evaluation, stop));
  return evaluation;
}

std::optional<Evaluation> copyWithSuspects(const Evaluation& fitted, const std::stop_token& stop) {
  if (fitted.isSearched) return fitted;
  Searched found = search(fitted, stop);
  if (stop.stop_requested()) return std::nullopt;
  Evaluation evaluation = fitted;
  take(evaluation, std::move(found));
  return evaluation;
}

Evaluation failedEvaluation(Session session, FailedWork failure) {
  Evaluation evaluation;
  evaluation.session = std::move(session);
  const bool isExamined = !failureOf([&] { evaluation.examined = examine(evaluation.session); });
  if (!isExamined) evaluation.examined.problems.clear();
  evaluation.examined.measurement.reset();
  evaluation.failure = std::move(failure);
  evaluation.journal = journalSummary(evaluation.session);
  return evaluation;
}

Evaluation withoutSuspects(Evaluation evaluation, FailedWork failure) {
  evaluation.isSearched = true;
  evaluation.searchFailure = std::move(failure);
  evaluation.journal = journalSummary(evaluation.session);
  return evaluation;
}

Evaluation evaluate(Session session) {
  return withSuspects(evaluateFit(std::move(session)));
}

std::vector<Finding> findingsOf(const Evaluation& evaluation) {
  std::vector<Finding> findings = inWords(evaluation.fit.findings);
  if (evaluation.searchFailure)
    findings.insert(findings.begin(),
                    {.severity = Severity::Warning, .text = sentencesOf(*evaluation.searchFailure)});
  if (evaluation.failure)
    findings.push_back({.severity = Severity::Error, .text = sentencesOf(*evaluation.failure)});
  return findings;
}

}  // namespace alidade
