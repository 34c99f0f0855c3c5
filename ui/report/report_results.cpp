#include "ui/report/report_results.h"

#include "core/adjustment/gross_errors/suspects.h"
#include "core/answers/beforehand.h"
#include "core/answers/fit_json.h"
#include "core/session/hindrance.h"
#include "ui/language/languages.h"

namespace alidade::ui {

std::optional<FitAnswer> fitAnswerOf(const Gap& gap, const std::string& name) {
  const Evaluation& evaluation = *gap.evaluation;
  const auto& measurement = evaluation.examined.measurement;
  if (!measurement || !hindrances(evaluation.session, evaluation.examined.problems).empty())
    return std::nullopt;
  if (!evaluation.failure.empty() || !evaluation.searchFailure.empty()) return std::nullopt;
  if (absence(*measurement, evaluation.fit.arcs.size(), evaluation.fit.findings)) return std::nullopt;
  FitAnswer answer{name, *measurement, evaluation.fit, evaluation.suspects};
  if (!evaluation.isSearched)
    answer.suspects = findSuspects(evaluation.session, *measurement, evaluation.fit);
  answer.diagnosis = gap.diagnosis;
  answer.arrivals = arrivalsOf(evaluation.session);
  answer.findDependences();
  return answer;
}

std::optional<std::string> resultsJson(const Gap& gap, const std::string& name) {
  const LanguageScope english(QStringLiteral("en"));
  const std::optional<FitAnswer> answer = fitAnswerOf(gap, name);
  if (!answer) return std::nullopt;
  return fitJson(*answer);
}

}  // namespace alidade::ui
