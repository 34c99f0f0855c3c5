#include "tests/fuzz/pipeline.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "app/console/diagnosis_text.h"
#include "app/console/fit_text.h"
#include "app/console/guidance_text.h"
#include "app/console/journal_text.h"
#include "app/console/plan_text.h"
#include "core/answers/beforehand.h"
#include "core/answers/budget_csv.h"
#include "core/answers/diagnosis_json.h"
#include "core/answers/fit_json.h"
#include "core/answers/guidance_json.h"
#include "core/answers/residuals_csv.h"
#include "core/answers/results_csv.h"
#include "core/base/utf8.h"
#include "core/certificate/calibration_certificate.h"
#include "core/diagnosis/diagnose.h"
#include "core/session/entry.h"
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

/// By the protocol it says it follows, else by its own rows.
void lead(const Session& session) {
  const auto own = protocolOf(session);
  if (!own) return require(!own.problem().what.empty(), "a protocol refused without words");
  SightingProtocol protocol = *own ? **own : protocolFromRows(session);
  if (protocol.positions.empty()) return;
  const Guidance guidance = guidanceOf(session, std::move(protocol));
  test::expectGuidance(guidance);
  requireText(console::guidanceText(name, guidance, circleUnitOf(session)));
  requireJson(guidanceJson(name, guidance));
}

void certify(const Session& session, const Measurement& measurement) {
  const SessionFit fit = fitSession(measurement);
  if (absence(measurement, fit.arcs.size(), fit.findings)) return;
  FitAnswer answer{name, measurement, fit, findSuspects(session, measurement, fit)};
  if (auto diagnosis = diagnose(measurement, fit)) answer.diagnosis = *std::move(diagnosis);
  for (const std::string& table :
       {residualsCsv(measurement, fit), budgetCsv(fit, answer.found()), resultsCsv(answer)})
    requireText(table);
  const std::string bytes = writeSession(session);
  const auto certificate =
      calibrationCertificate({session, answer, name, bytes}, {.version = "0", .measuredOn = "2026-03-01"});
  if (!certificate) return test::expectSentence(certificate.problem().text());
  require(certificate->xml.starts_with("<?xml") && !firstIllFormedByte(certificate->xml),
          "a certificate that is none");
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
  requireText(console::journalText(name, session));
  requireJson(console::journalJson(name, session));
  lead(session);
  const Examined examined = examine(session);
  for (const Problem& problem : examined.problems) test::expectSentence(problem.text());
  if (!examined.measurement)
    return require(!examined.problems.empty(), "nothing to fit, and no reason given");
  fit(session, *examined.measurement);
  diagnoseIt(*examined.measurement);
  certify(session, *examined.measurement);
  review(session);
}

}  // namespace alidade::fuzz
