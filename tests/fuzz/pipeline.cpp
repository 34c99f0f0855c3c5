#include "tests/fuzz/pipeline.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/console/diagnosis_json.h"
#include "app/console/diagnosis_text.h"
#include "app/console/findings_output.h"
#include "app/console/fit_json.h"
#include "app/console/fit_text.h"
#include "app/console/plan_text.h"
#include "core/adjustment/monte_carlo.h"
#include "core/adjustment/session_fit.h"
#include "core/adjustment/suspects.h"
#include "core/base/utf8.h"
#include "core/diagnosis/diagnosis.h"
#include "core/diagnosis/plan_review.h"
#include "core/session/measurement.h"
#include "core/session/session_file.h"
#include "core/simulation/planned_session.h"
#include "tests/fuzz/require.h"

namespace alidade::fuzz {

namespace {

const std::string name = "fuzzed";

void requireShare(double value, const std::string& what) {
  require(value >= 0 && value <= 1, what + " is " + std::to_string(value));
}

void requireSentence(const std::string& text) {
  require(!text.empty(), "a refusal without words");
}

void requireText(const std::string& text) {
  require(!text.empty() && text.back() == '\n', "a text that does not end");
  require(!firstIllFormedByte(text), "a text that is no UTF-8");
}

void requireJson(const std::string& text) {
  require(nlohmann::json::accept(text), "JSON that is none");
}

void requireNumbers(const IntersectionEstimate& estimate) {
  require(std::isfinite(estimate.value), "an intersection that is no number");
  require(estimate.sigma >= 0 && estimate.expanded >= 0, "an uncertainty that is none");
}

void check(const Suspect& suspect) {
  requireSentence(suspect.sentence);
  for (const Proposal& proposal : suspect.proposals) {
    requireShare(proposal.share, "the share of a proposal");
    require(!proposal.changes.empty(), "a proposal that changes nothing");
  }
}

void check(const SessionFit& fit) {
  require(fit.noise.factor > 0, "a noise scale that is not positive");
  for (const ArcSigma& sigma : fit.sigmas)
    require(sigma.x >= 0 && sigma.y >= 0 && sigma.radius >= 0, "a standard uncertainty that is none");
  for (const ArcMisfit& misfit : fit.joint.misfits)
    require(misfit.chiSquare >= 0, "a misfit that is negative");
  if (!fit.intersection) return;
  require(std::isfinite(fit.intersection->value), "an intersection that is no number");
  require(fit.intersection->sigma >= 0 && fit.intersection->expanded >= 0, "an uncertainty that is none");
}

void fit(const Session& session, const Measurement& measurement) {
  const SessionFit fit = fitSession(measurement);
  check(fit);
  const std::vector<Suspect> suspects = findSuspects(session, measurement, fit);
  for (const Suspect& suspect : suspects) check(suspect);
  std::optional<MonteCarlo> draws;
  if (fit.intersection) draws = propagateDistributions(measurement, fit, {.draws = 100, .threads = 1});
  requireText(console::fitText(name, measurement, fit, suspects, draws));
  requireJson(console::fitJson(name, measurement, fit, suspects, draws));
  const PublishedSessionFit published = fitSessionAsPublished(measurement);
  requireText(console::fitText(name, measurement, published));
  requireJson(console::fitJson(name, measurement, published));
}

void check(const Diagnosis& diagnosis) {
  requireSentence(diagnosis.sentence);
  for (const Cause& cause : diagnosis.causes) requireShare(cause.probability, "a probability");
  for (const GapShare& share : diagnosis.where) requireShare(share.share, "a share of the gap");
  for (const GapSize& size : {diagnosis.gap, diagnosis.after}) {
    require(size.rms >= 0, "an rms that is none");
    if (!std::isnan(size.pValue)) requireShare(size.pValue, "a p-value");
  }
  for (const Candidate& candidate : diagnosis.candidates)
    require(!std::isnan(candidate.logBayesFactor), "evidence that is no number");
  if (diagnosis.before) requireNumbers(*diagnosis.before);
  if (diagnosis.afterwards) requireNumbers(*diagnosis.afterwards);
}

void diagnoseIt(const Measurement& measurement) {
  const Result<std::vector<Finding>> findings = console::findingsBeforehand(measurement);
  if (!findings) return requireSentence(findings.problem().what);
  const Result<Diagnosis> diagnosis = diagnose(measurement);
  if (!diagnosis) return requireSentence(diagnosis.problem().what);
  check(*diagnosis);
  requireText(console::diagnosisText(name, *diagnosis, *findings));
  requireJson(console::diagnosisJson(name, *diagnosis, *findings));
}

void review(const Session& session) {
  const Examined planned = examine(withPlannedReadings(session));
  if (!planned.measurement) return;
  const Result<std::vector<Finding>> findings = console::findingsBeforehand(*planned.measurement);
  if (!findings) return requireSentence(findings.problem().what);
  const Result<PlanReview> review = reviewPlan(*planned.measurement);
  if (!review) return requireSentence(review.problem().what);
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
  for (const Problem& problem : examined.problems) requireSentence(problem.text());
  if (!examined.measurement)
    return require(!examined.problems.empty(), "nothing to fit, and no reason given");
  fit(session, *examined.measurement);
  diagnoseIt(*examined.measurement);
  review(session);
}

}  // namespace alidade::fuzz
