#include "core/answers/fit_answer.h"

#include "core/answers/beforehand.h"
#include "core/session/hindrance.h"

namespace alidade {

namespace {

std::optional<Problem> whyNone(const Evaluation& evaluation) {
  if (auto problem = firstHindrance(evaluation.session, evaluation.examined.problems)) return problem;
  if (evaluation.failure) return Problem{sentencesOf(*evaluation.failure)};
  if (evaluation.searchFailure) return Problem{sentencesOf(*evaluation.searchFailure)};
  return absence(evaluation.examined.measurement.value(), evaluation.fit.arcs.size(),
                 evaluation.fit.findings);
}

}  // namespace

Result<FitAnswer> fitAnswerOf(const Gap& gap, const std::string& name) {
  const Evaluation& evaluation = *gap.evaluation;
  if (auto problem = whyNone(evaluation)) return *std::move(problem);
  const Measurement& measurement = *evaluation.examined.measurement;
  FitAnswer answer{name, measurement, evaluation.fit, evaluation.suspects};
  if (!evaluation.isSearched) answer.suspects = findSuspects(evaluation.session, measurement, evaluation.fit);
  answer.diagnosis = gap.diagnosis;
  answer.arrivals = arrivalsOf(evaluation.session);
  answer.dependences =
      gap.dependences ? *gap.dependences : dependencesOf(measurement, answer.fit, gap.found());
  return answer;
}

}  // namespace alidade
