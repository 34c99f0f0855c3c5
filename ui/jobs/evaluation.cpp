#include "ui/jobs/evaluation.h"

#include <utility>

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

Evaluation evaluate(Session session) {
  return withSuspects(evaluateFit(std::move(session)));
}

}  // namespace alidade::ui
