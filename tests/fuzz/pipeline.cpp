#include "tests/fuzz/pipeline.h"

#include <nlohmann/json.hpp>

#include "app/console/diagnosis_text.h"
#include "app/console/fit_text.h"
#include "app/console/plan_text.h"
#include "core/answers/beforehand.h"
#include "core/answers/diagnosis_json.h"
#include "core/answers/fit_json.h"
#include "core/base/utf8.h"
#include "core/diagnosis/diagnose.h"
#include "core/wording/diagnosis_fault.h"
#include "tests/fuzz/require.h"
#include "tests/support/every_answer.h"

namespace alidade::fuzz {

namespace {

const std::string name = "fuzzed";

void requireText(const std::string& text) {
  require(!text.empty() && text.back() == '\n', "a text that does not end");
  require(!firstIllFormedByte(text), "a text that is no UTF-8");
}

void requireJson(const std::string& text) {
  require(nlohmann::json::accept(text), "JSON that is none");
}

void fit(const Session& session, const Measurement& measurement) {
  const SessionFit fit = fitSession(measurement);
  test::expectFit(measurement, fit);
  const std::vector<Suspect> suspects = findSuspects(session, measurement, fit);
  test::expectSuspects(session, suspects);
  requireText(console::fitText({name, measurement, fit, suspects}));
  requireJson(fitJson({name, measurement, fit, suspects}));
  const PublishedSessionFit published = fitSessionAsPublished(measurement);
  requireText(console::fitText(name, measurement, published));
  requireJson(fitJson(name, measurement, published));
}

void diagnoseIt(const Measurement& measurement) {
  const auto diagnosis = diagnose(measurement);
  if (!diagnosis) return test::expectSentence(problemOf(diagnosis.problem()).text());
  test::expectDiagnosis(*diagnosis);
  const Result<std::vector<Finding>> findings = findingsBeforehand(measurement, fitSession(measurement));
  if (!findings) return test::expectSentence(findings.problem().text());
  requireText(console::diagnosisText(name, *diagnosis, *findings));
  requireJson(diagnosisJson(name, *diagnosis, *findings));
}

void review(const Session& session) {
  const Examined planned = examine(withPlannedReadings(session));
  if (!planned.measurement) return;
  const auto review = reviewPlan(*planned.measurement);
  if (!review) return test::expectSentence(problemOf(review.problem()).text());
  const Result<std::vector<Finding>> findings =
      findingsBeforehand(*planned.measurement, fitSession(*planned.measurement));
  if (!findings) return test::expectSentence(findings.problem().text());
  requireText(console::planText(name, *review, *findings));
  requireJson(console::planJson(name, *review, *findings));
}

/// A number typed as 02 is kept as 2; from then on nothing changes any more.
void writeAndRead(const Session& session) {
  const std::string text = writeSession(session);
  const Result<Session> again = readSession(text);
  require(static_cast<bool>(again), "a session that was written cannot be read");
  require(writeSession(*again) == text, "a session that changes when it is read and written");
}

}  // namespace

void workThrough(const Session& session) {
  writeAndRead(session);
  const Examined examined = examine(session);
  for (const Problem& problem : examined.problems) test::expectSentence(problem.text());
  if (!examined.measurement)
    return require(!examined.problems.empty(), "nothing to fit, and no reason given");
  fit(session, *examined.measurement);
  diagnoseIt(*examined.measurement);
  review(session);
}

}  // namespace alidade::fuzz
