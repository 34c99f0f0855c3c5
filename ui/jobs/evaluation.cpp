#include "ui/jobs/evaluation.h"

#include <utility>

#include "core/base/failure.h"

namespace alidade::ui {

Evaluation evaluateFit(Session session) {
  Evaluation evaluation;
  evaluation.session = std::move(session);
  evaluation.examined = examine(evaluation.session);
  if (const auto& measurement = evaluation.examined.measurement) {
    evaluation.fit = fitSession(*measurement);
    evaluation.published = fitSessionAsPublished(*measurement);
    evaluation.twoFaces = compareFaces(*measurement);
    evaluation.isSearched = evaluation.fit.arcs.empty();
  }
  return evaluation;
}

Evaluation withSuspects(Evaluation evaluation, const std::stop_token& stop) {
  if (std::exchange(evaluation.isSearched, true)) return evaluation;
  evaluation.suspects =
      findSuspects(evaluation.session, *evaluation.examined.measurement, evaluation.fit, {}, stop);
  if (auto finding = suspectsFinding(evaluation.suspects))
    evaluation.fit.findings.insert(evaluation.fit.findings.begin(), *std::move(finding));
  return evaluation;
}

Evaluation failedEvaluation(Session session, const std::string& failure) {
  Evaluation evaluation;
  evaluation.session = std::move(session);
  const bool isExamined = !failureOf([&] { evaluation.examined = examine(evaluation.session); });
  if (!isExamined) evaluation.examined.problems.clear();
  evaluation.examined.measurement.reset();
  evaluation.failure = failure;
  evaluation.fit.findings.push_back({.severity = Severity::Error, .text = failure});
  return evaluation;
}

Evaluation withoutSuspects(Evaluation evaluation, const std::string& failure) {
  evaluation.isSearched = true;
  evaluation.fit.findings.insert(evaluation.fit.findings.begin(),
                                 {.severity = Severity::Warning, .text = failure});
  return evaluation;
}

Evaluation evaluate(Session session) {
  return withSuspects(evaluateFit(std::move(session)));
}

}  // namespace alidade::ui
