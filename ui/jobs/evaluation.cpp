#include "ui/jobs/evaluation.h"

#include <utility>

namespace alidade::ui {

Evaluation evaluate(Session session) {
  Evaluation evaluation;
  evaluation.session = std::move(session);
  evaluation.examined = examine(evaluation.session);
  if (const auto& measurement = evaluation.examined.measurement) {
    evaluation.fit = fitSession(*measurement);
    evaluation.published = fitSessionAsPublished(*measurement);
    evaluation.suspects = findSuspects(evaluation.session, *measurement, evaluation.fit);
    if (auto finding = suspectsFinding(evaluation.suspects))
      evaluation.fit.findings.insert(evaluation.fit.findings.begin(), *std::move(finding));
    evaluation.twoFaces = compareFaces(*measurement);
  }
  return evaluation;
}

}  // namespace alidade::ui
