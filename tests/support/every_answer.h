#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/adjustment/result/session_fit.h"
#include "core/adjustment/result/two_faces.h"
#include "core/answers/beforehand.h"
#include "core/answers/guidance_answer.h"
#include "core/base/utf8.h"
#include "core/certificate/calibration_certificate.h"
#include "core/diagnosis/decision.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/plan_review.h"
#include "core/guidance/advised_protocol.h"
#include "core/session/measurement.h"
#include "core/session/session_file.h"
#include "core/simulation/planned_session.h"
#include "core/simulation/protocol.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/findings.h"
#include "core/wording/guidance.h"
#include "core/wording/suspects.h"

namespace alidade::test {

// The conditions on every answer to any input. It exists or a sentence says why not. Every number shown is
// finite and in its range, and sentences contain no “nan” or “inf”.

inline void expectSentence(const std::string& text) {
  EXPECT_FALSE(text.empty());
  for (const char* word : {"nan", "inf "}) EXPECT_EQ(text.find(word), std::string::npos) << text;
}

/// Requires a finite number.
inline void expectNumber(double value, const char* what) {
  EXPECT_TRUE(std::isfinite(value)) << what << " is " << value;
}

inline void expectChance(double value, const char* what) {
  EXPECT_GE(value, 0) << what;
  EXPECT_LE(value, 1) << what;
}

inline void expectFit(const Measurement& measurement, const SessionFit& fit) {
  for (const Finding& finding : inWords(fit.findings)) expectSentence(finding.text);
  if (fit.arcs.empty()) {
    EXPECT_FALSE(fit.findings.empty());
    EXPECT_FALSE(fit.intersection);
    return;
  }
  ASSERT_EQ(fit.sigmas.size(), fit.arcs.size());
  ASSERT_EQ(fit.budgets.size(), fit.arcs.size());
  EXPECT_TRUE(fit.joint.isDetermined());
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    expectNumber(fit.arcs[i].circle.x, "x");
    expectNumber(fit.arcs[i].circle.y, "y");
    expectNumber(fit.arcs[i].circle.radius, "radius");
    EXPECT_GT(fit.arcs[i].circle.radius, 0);
    for (const double correlation : {fit.sigmas[i].radiusX, fit.sigmas[i].radiusY})
      if (!std::isnan(correlation)) expectChance(std::abs(correlation), "correlation");
    expectNumber(fit.arcs[i].residualRms, "rms");
    for (const double sigma : {fit.sigmas[i].x, fit.sigmas[i].y, fit.sigmas[i].radius}) {
      expectNumber(sigma, "sigma");
      EXPECT_GE(sigma, 0);
    }
  }
  expectNumber(fit.noise.factor, "s0");
  EXPECT_GT(fit.noise.degreesOfFreedom, 0);
  for (const EffectEstimate& estimate : fit.effects) {
    expectNumber(estimate.value, estimate.name.c_str());
    expectNumber(estimate.sigma, estimate.name.c_str());
    EXPECT_GE(estimate.sigma, 0) << estimate.name;
  }
  for (const AdjustedReading& reading : fit.joint.readings) expectChance(reading.redundancy, "redundancy");
  EXPECT_EQ(fit.intersection.has_value(), fit.arcAt(0) && fit.arcAt(180));
  if (!fit.intersection) return;
  expectNumber(fit.intersection->value, "intersection");
  expectNumber(fit.intersection->sigma, "sigma of it");
  expectNumber(fit.intersection->expanded, "U");
  EXPECT_GE(fit.intersection->expanded, 0);
  EXPECT_GT(fit.intersection->effectiveDegreesOfFreedom, 0);
  EXPECT_EQ(fit.verdict.has_value(), measurement.tolerance.has_value());
  EXPECT_GE(fit.intersection->sigma, 0);
  if (fit.verdict == Verdict::Accept) {
    EXPECT_LE(std::abs(fit.intersection->value) + fit.intersection->expanded, *measurement.tolerance);
  }
}

inline void expectSuspects(const Session& session, const std::vector<Suspect>& suspects) {
  for (const Suspect& suspect : suspects) {
    expectSentence(sentenceOf(suspect));
    EXPECT_LT(*suspect.where.position, session.positions.size());
    EXPECT_LT(*suspect.where.reading, session.positions[*suspect.where.position].readings.size());
    for (const Proposal& proposal : suspect.proposals) {
      expectSentence(sentenceOf(proposal));
      expectChance(proposal.share, "share of a proposal");
    }
  }
}

inline void expectEstimate(const std::optional<IntersectionEstimate>& estimate) {
  if (!estimate) return;
  expectNumber(estimate->value, "Δd");
  expectNumber(estimate->sigma, "σ of Δd");
  expectNumber(estimate->expanded, "U of Δd");
  EXPECT_GE(estimate->sigma, 0);
  EXPECT_GE(estimate->expanded, 0);
}

inline void expectDiagnosis(const Diagnosis& diagnosis) {
  expectSentence(sentenceOf(diagnosis));
  for (const GapSize& size : {diagnosis.gap, diagnosis.after}) {
    expectNumber(size.rms, "rms");
    if (!std::isnan(size.pValue)) expectChance(size.pValue, "p");
  }
  expectEstimate(diagnosis.before);
  expectEstimate(diagnosis.afterwards);
  EXPECT_EQ(diagnosis.before.has_value(), diagnosis.afterwards.has_value());
  expectNumber(diagnosis.shrink.inSample, "shrinkage");
  EXPECT_LE(diagnosis.shrink.inSample, 1);
  if (diagnosis.shape) expectChance(diagnosis.shape->share, diagnosis.shape->follows.c_str());
  expectChance(diagnosis.shrink.ofExcess, "shrinkage of the excess");
  for (const Cause& cause : diagnosis.causes) {
    expectChance(cause.probability, cause.effect.c_str());
    for (const CauseParameter& parameter : cause.parameters) {
      expectNumber(parameter.value, parameter.name.c_str());
      expectNumber(parameter.sigma, parameter.name.c_str());
      EXPECT_GE(parameter.sigma, 0) << parameter.name;
    }
    for (const ReadingDeviation& reading : cause.readings) expectNumber(reading.size, "blamed reading");
  }
  for (const Candidate& candidate : diagnosis.candidates) {
    EXPECT_FALSE(std::isnan(candidate.logBayesFactor)) << candidate.effect;
    expectNumber(candidate.visibleSigma, candidate.effect.c_str());
    EXPECT_GE(candidate.visibleSigma, 0) << candidate.effect;
  }
  for (const GapShare& share : diagnosis.where) expectChance(share.share, share.by.c_str());
  for (const GapStep& step : diagnosis.steps) {
    expectNumber(step.size.rms, step.effect.c_str());
    expectEstimate(step.intersection);
  }
  for (const UndetectableEffect& undetectable : diagnosis.undetectable) {
    expectNumber(undetectable.influence, undetectable.effect.c_str());
    EXPECT_GE(undetectable.influence, 0) << undetectable.effect;
  }
}

/// Requests everything that the program derives from a session.
inline void expectAnswers(const Session& session) {
  const Examined examined = examine(session);
  for (const Problem& problem : examined.problems) expectSentence(problem.text());
  if (!examined.measurement) {
    EXPECT_FALSE(examined.problems.empty());
    return;
  }
  const Measurement& measurement = *examined.measurement;
  const SessionFit fit = fitSession(measurement);
  expectFit(measurement, fit);
  expectSuspects(session, findSuspects(session, measurement, fit));
  const auto diagnosis = diagnose(measurement);
  // Known values may be so wrong that nothing fits them, and a fit that ran out of iterations is no start.
  if (measurement.known.empty() && fit.joint.converged()) {
    EXPECT_EQ(static_cast<bool>(diagnosis), !fit.arcs.empty());
  }
  diagnosis ? expectDiagnosis(*diagnosis) : expectSentence(problemOf(diagnosis.problem()).text());
}

inline void expectPair(const ExpandedPair& pair, const char* what) {
  expectNumber(pair.ofFit, what);
  EXPECT_GE(pair.ofFit, 0) << what;
  if (!pair.asMeasured) return;
  expectNumber(*pair.asMeasured, what);
  EXPECT_GE(*pair.asMeasured, 0) << what;
}

/// A circle reads from 0° to 360°, an elevation from −90° to 270°.
inline void expectGuidance(const Guidance& guidance) {
  expectSentence(progressSentences(guidance.progress));
  EXPECT_EQ(guidance.expected.size(), guidance.progress.sightings.size());
  for (const auto& expected : guidance.expected) {
    if (!expected) continue;
    expectNumber(expected->horizontal.radians(), "expected direction");
    expectNumber(expected->vertical.radians(), "expected vertical angle");
    EXPECT_GE(expected->horizontal.radians(), 0);
    EXPECT_GT(expected->tolerance.radians(), 0);
  }
  for (const SightingsToRepeat& toRepeat : guidance.allToRepeat) {
    expectSentence(repeatSentence(toRepeat, guidance.progress));
    for (const std::size_t sighting : toRepeat.sightings)
      EXPECT_LT(sighting, guidance.progress.sightings.size());
  }
  const Outlook& outlook = guidance.outlook;
  if (outlook.now) expectPair(*outlook.now, "U now");
  if (outlook.limit) expectPair(*outlook.limit, "U at the limit");
  if (outlook.needed) expectPair(*outlook.needed, "U that is needed");
  for (const RoundsAhead& ahead : outlook.ahead) expectPair(ahead.expanded, "U ahead");
  if (const std::string sentences = outlookSentences(outlook, guidance.progress); !sentences.empty())
    expectSentence(sentences);
}

/// Follows a protocol of the session's own rows, which is complete, and a named plan.
inline void expectGuidances(const Session& session) {
  std::vector<SightingProtocol> protocols{protocolFromRows(session), templateOf(namedProtocols().front())};
  for (SightingProtocol& protocol : protocols)
    if (!protocol.positions.empty()) expectGuidance(guidanceOf(session, std::move(protocol)));
}

/// Checks the certificate, if there is anything to certify.
inline void expectCertificate(const Session& session, const FitAnswer& answer) {
  if (absence(answer.measurement, answer.fit.arcs.size(), answer.fit.findings)) return;
  const std::string bytes = writeSession(session);
  const auto certificate =
      calibrationCertificate({session, answer, "session.alidade", bytes},
                             {.version = "0", .measuredOn = "2026-03-01", .isDraft = true});
  if (!certificate) return expectSentence(certificate.problem().text());
  EXPECT_TRUE(certificate->xml.starts_with("<?xml"));
  EXPECT_FALSE(firstIllFormedByte(certificate->xml));
  for (const char* none : {">nan<", ">-nan<", ">inf<", ">-inf<"})
    EXPECT_EQ(certificate->xml.find(none), std::string::npos) << none;
}

/// Less frequent requests: the plan, the published method, draws, guidance, the certificate.
inline void expectFurtherAnswers(const Session& session) {
  const Examined planned = examine(withPlannedReadings(session));
  if (planned.measurement) {
    const auto review = reviewPlan(*planned.measurement);
    if (!review) expectSentence(problemOf(review.problem()).text());
  }
  const Examined examined = examine(session);
  if (!examined.measurement) return;
  const PublishedSessionFit published = fitSessionAsPublished(*examined.measurement);
  for (const PublishedFit& fit : published.arcs) EXPECT_GT(fit.arc.circle.radius, 0);
  for (const Finding& finding : inWords(published.findings)) expectSentence(finding.text);
  const SessionFit fit = fitSession(*examined.measurement);
  const auto drawn = propagateDistributions(*examined.measurement, fit, {.draws = 200, .threads = 1});
  if (drawn && drawn->intersection) {
    expectNumber(drawn->intersection->mean, "mean of the draws");
    expectNumber(drawn->intersection->high - drawn->intersection->low, "interval of the draws");
  }
  const std::string name = "every state";
  FitAnswer answer{name, *examined.measurement, fit};
  if (auto diagnosis = diagnose(*examined.measurement, fit)) answer.diagnosis = *std::move(diagnosis);
  if (const auto decision = decideAcceptance(*examined.measurement, fit, answer.found());
      decision && decision->conformance)
    expectChance(*decision->conformance, "conformance");
  expectCertificate(session, answer);
  expectGuidances(session);
}

}  // namespace alidade::test
