#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/adjustment/result/session_fit.h"
#include "core/adjustment/result/two_faces.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/plan_review.h"
#include "core/session/measurement.h"
#include "core/session/session_file.h"
#include "core/simulation/planned_session.h"
#include "core/wording/diagnosis_fault.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/findings.h"
#include "core/wording/suspects.h"

namespace alidade::test {

// What every answer keeps to, whatever was typed: it is there or a sentence says why not, every number that
// is shown is one, probabilities are probabilities, and no sentence speaks of what is no number.

inline void expectSentence(const std::string& text) {
  EXPECT_FALSE(text.empty());
  for (const char* word : {"nan", "inf "}) EXPECT_EQ(text.find(word), std::string::npos) << text;
}

/// Only "fin", "inf": ids and units are no sentences.
inline void expectNumber(double value, const char* what) {
  EXPECT_TRUE(std::isfinite(value)) << what << " is " << value;
}

inline void expectChance(double value, const char* what) {
  EXPECT_GE(value, 0) << what;
  EXPECT_LE(value, 1 + 1e-12) << what;
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
  }
  EXPECT_EQ(fit.intersection.has_value(), fit.arcAt(0) && fit.arcAt(180));
  if (!fit.intersection) return;
  expectNumber(fit.intersection->value, "intersection");
  expectNumber(fit.intersection->sigma, "sigma of it");
  expectNumber(fit.intersection->expanded, "U");
  EXPECT_GE(fit.intersection->expanded, 0);
  EXPECT_GT(fit.intersection->effectiveDegreesOfFreedom, 0);
  EXPECT_EQ(fit.verdict.has_value(), measurement.tolerance.has_value());
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
  expectChance(diagnosis.shrink.ofExcess, "shrinkage of the excess");
  for (const Cause& cause : diagnosis.causes) {
    expectChance(cause.probability, cause.effect.c_str());
    for (const CauseParameter& parameter : cause.parameters) {
      expectNumber(parameter.value, parameter.name.c_str());
      expectNumber(parameter.sigma, parameter.name.c_str());
    }
    for (const ReadingDeviation& reading : cause.readings) expectNumber(reading.size, "blamed reading");
  }
  for (const Candidate& candidate : diagnosis.candidates) {
    EXPECT_FALSE(std::isnan(candidate.logBayesFactor)) << candidate.effect;
    expectNumber(candidate.visibleSigma, candidate.effect.c_str());
  }
  for (const GapShare& share : diagnosis.where) expectChance(share.share, share.by.c_str());
  for (const GapStep& step : diagnosis.steps) {
    expectNumber(step.size.rms, step.effect.c_str());
    expectEstimate(step.intersection);
  }
  for (const UnseenEffect& unseen : diagnosis.unseen) expectNumber(unseen.influence, unseen.effect.c_str());
}

/// Asks for everything that the program makes of a session.
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
  EXPECT_EQ(static_cast<bool>(diagnosis), !fit.arcs.empty());
  diagnosis ? expectDiagnosis(*diagnosis) : expectSentence(problemOf(diagnosis.problem()).text());
}

/// What is asked for more rarely: the plan, the published method, draws.
inline void expectFurtherAnswers(const Session& session) {
  const Examined planned = examine(withPlannedReadings(session));
  if (planned.measurement) {
    const auto review = reviewPlan(*planned.measurement);
    if (!review) expectSentence(problemOf(review.problem()).text());
  }
  const Examined examined = examine(session);
  if (!examined.measurement) return;
  const PublishedSessionFit published = fitSessionAsPublished(*examined.measurement);
  for (const Finding& finding : inWords(published.findings)) expectSentence(finding.text);
  const SessionFit fit = fitSession(*examined.measurement);
  const auto drawn = propagateDistributions(*examined.measurement, fit, {.draws = 200, .threads = 1});
  if (drawn && drawn->intersection) {
    expectNumber(drawn->intersection->mean, "mean of the draws");
    expectNumber(drawn->intersection->high - drawn->intersection->low, "interval of the draws");
  }
}

}  // namespace alidade::test
