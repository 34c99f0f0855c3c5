#include "tests/fuzz/pipeline.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "app/console/diagnosis_text.h"
#include "app/console/fit_text.h"
#include "app/console/guidance_text.h"
#include "app/console/journal_text.h"
#include "core/answers/beforehand.h"
#include "core/answers/csv_answers.h"
#include "core/answers/diagnosis_json.h"
#include "core/answers/fit_json.h"
#include "core/answers/guidance_answer.h"
#include "core/base/utf8.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/result/sighting_plan.h"
#include "core/session/entry.h"
#include "core/session/protocol_progress.h"
#include "core/wording/diagnosis_sentence.h"
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

void reportFit(const Session& session, const FitAnswer& answer) {
  test::expectFit(answer.measurement, answer.fit);
  test::expectSuspects(session, answer.suspects);
  requireText(console::fitText(answer));
  requireJson(fitJson(answer));
  const PublishedSessionFit published = fitSessionAsPublished(answer.measurement);
  requireText(console::fitText(name, published));
  requireJson(fitJson(name, answer.measurement, published));
}

/// Adds the diagnosis to the answer.
void diagnoseIt(const Session& session, FitAnswer& answer) {
  auto diagnosis = diagnose(answer.measurement, answer.fit);
  if (!diagnosis) return test::expectSentence(problemOf(diagnosis.problem()).text());
  answer.diagnosis = *std::move(diagnosis);
  test::expectDiagnosis(*answer.diagnosis);
  const Result<std::vector<Finding>> findings = findingsBeforehand(answer.measurement, answer.fit);
  if (!findings) return test::expectSentence(findings.problem().text());
  auto evaluation = std::make_shared<Evaluation>();
  evaluation->session = session;
  evaluation->examined.measurement = answer.measurement;
  evaluation->fit = answer.fit;
  requireText(console::diagnosisText(name, gapOf(std::move(evaluation), *answer.diagnosis), *findings));
  requireJson(diagnosisJson(name, *answer.diagnosis, *findings));
}

void review(const Session& session) {
  const Examined planned = examine(withPlannedReadings(session));
  if (!planned.measurement) return;
  const auto review = reviewPlan(*planned.measurement);
  if (!review) return test::expectSentence(problemOf(review.problem()).text());
  const Result<std::vector<Finding>> findings =
      findingsBeforehand(*planned.measurement, fitSession(*planned.measurement));
  if (!findings) return test::expectSentence(findings.problem().text());
  requireText(console::planText(name, *review, *findings,
                                effortOf(*planned.measurement, sightingMinutesOf(session))));
  requireJson(console::planJson(name, *review, *findings, *planned.measurement));
}

/// Follows the protocol that the session names, otherwise its own rows.
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

void certify(const Session& session, const FitAnswer& answer) {
  if (absence(answer.measurement, answer.fit.arcs.size(), answer.fit.findings)) return;
  for (const std::string& table : {residualsCsv(answer.measurement, answer.fit),
                                   budgetCsv(answer.fit, answer.found()), resultsCsv(answer)})
    requireText(table);
  test::expectCertificate(session, answer);
}

/// A number typed as 02 is kept as 2; after that nothing changes.
void writeAndRead(const Session& session) {
  const std::string text = writeSession(session);
  const Result<Session> again = readSession(text);
  require(static_cast<bool>(again), "a session that was written cannot be read");
  require(writeSession(*again) == text, "a session that changes when it is read and written");
}

}  // namespace

void workThrough(const Session& session) {
  writeAndRead(session);
  const JournalCheck check = checkJournal(session);
  requireText(console::journalText(name, session, check));
  requireJson(console::journalJson(name, session, check));
  lead(session);
  const Examined examined = examine(session);
  for (const Problem& problem : examined.problems) test::expectSentence(problem.text());
  if (!examined.measurement)
    return require(!examined.problems.empty(), "nothing to fit, and no reason given");
  const Measurement& measurement = *examined.measurement;
  const SessionFit fit = fitSession(measurement);
  FitAnswer answer{name, measurement, fit, findSuspects(session, measurement, fit)};
  reportFit(session, answer);
  diagnoseIt(session, answer);
  certify(session, answer);
  review(session);
}

}  // namespace alidade::fuzz
