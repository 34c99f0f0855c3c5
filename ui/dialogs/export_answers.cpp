#include "ui/dialogs/export_answers.h"

#include <utility>

#include "core/answers/beforehand.h"
#include "core/answers/csv_answers.h"
#include "core/answers/diagnosis_json.h"
#include "core/answers/fit_json.h"
#include "core/base/sha256.h"
#include "core/diagnosis/diagnose.h"
#include "core/session/hindrance.h"
#include "core/session/session_file.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade::ui {
namespace {

struct Fitted {
  Measurement measurement;
  SessionFit fit;
};

Result<Fitted> fitted(const Session& session) {
  Examined examined = examine(session);
  if (auto problem = firstHindrance(session, examined.problems)) return *std::move(problem);
  Measurement measurement = std::move(examined.measurement).value();
  SessionFit fit = fitSession(measurement);
  if (auto problem = absence(measurement, fit.arcs.size(), fit.findings)) return *std::move(problem);
  return Fitted{std::move(measurement), std::move(fit)};
}

Result<Diagnosis, DiagnosisFault> diagnosed(const Fitted& of) {
  return diagnose(of.measurement, of.fit, {.withAttainable = true});
}

}  // namespace

Result<std::string> residualsAnswer(const Session& session, const std::string&) {
  const Result<Fitted> of = fitted(session);
  if (!of) return of.problem();
  return residualsCsv(of->measurement, of->fit);
}

Result<std::string> resultAnswer(const Session& session, const std::string& name) {
  const Gap gap = assessGap(std::make_shared<const Evaluation>(evaluate(session)));
  const Result<FitAnswer> answer = fitAnswerOf(gap, name, writeSession(session));
  if (!answer) return answer.problem();
  return fitJson(*answer);
}

Result<std::string> gapAnswer(const Session& session, const std::string& name) {
  const Result<Fitted> of = fitted(session);
  if (!of) return of.problem();
  const Result<std::vector<Finding>> findings = findingsBeforehand(of->measurement, of->fit);
  if (!findings) return findings.problem();
  const auto diagnosis = diagnosed(*of);
  if (!diagnosis) return problemOf(diagnosis.problem());
  return diagnosisJson(name, *diagnosis, *findings, sha256(writeSession(session)));
}

Result<std::string> budgetAnswer(const Session& session, const std::string&) {
  const Result<Fitted> of = fitted(session);
  if (!of) return of.problem();
  const auto diagnosis = diagnosed(*of);
  return budgetCsv(of->fit, diagnosis ? &*diagnosis : nullptr);
}

}  // namespace alidade::ui
