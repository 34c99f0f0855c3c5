#include "ui/report/report_results.h"

#include "core/answers/fit_answer.h"
#include "core/answers/fit_json.h"
#include "ui/language/languages.h"

namespace alidade::ui {

std::optional<std::string> resultsJson(const Gap& gap, const std::string& name, std::string_view file) {
  const LanguageScope english(QStringLiteral("en"));
  const Result<FitAnswer> answer = fitAnswerOf(gap, name, file);
  if (!answer) return std::nullopt;
  return fitJson(*answer);
}

}  // namespace alidade::ui
