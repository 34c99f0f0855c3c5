#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/random_source.h"
#include "core/diagnosis/decision.h"
#include "core/diagnosis/diagnose.h"
#include "core/simulation/blind_trial.h"

namespace alidade::test {

// Verdicts of simulated sessions: unchanged, with one row left out, with one circle misread by 60″.

struct JudgedSession {
  Measurement measurement;
  SessionFit fit;
  Diagnosis diagnosis;
  AcceptanceDecision decision;
};

/// The fit, diagnosis and decision; absent without a decision.
inline std::optional<JudgedSession> judged(Measurement measurement) {
  JudgedSession session{std::move(measurement), {}, {}, {}};
  session.fit = fitSession(session.measurement);
  auto diagnosis = diagnose(session.measurement, session.fit, {.forVerdict = true});
  if (!diagnosis) return std::nullopt;
  session.diagnosis = *std::move(diagnosis);
  const auto decision = decideAcceptance(session.measurement, session.fit, &session.diagnosis);
  if (!decision) return std::nullopt;
  session.decision = *decision;
  return session;
}

inline Measurement without(Measurement measurement, std::size_t arc, std::size_t sighting) {
  auto& sightings = measurement.arcs[arc].sightings;
  sightings.erase(sightings.begin() + static_cast<std::ptrdiff_t>(sighting));
  return measurement;
}

/// A blind trial. Its tolerance differs from the true |Δd| by about the usual U; two of three truths conform.
inline Measurement drawnAcceptance(const std::string& protocol, const std::vector<std::string>& kinds,
                                   std::uint64_t seed) {
  constexpr std::uint64_t stream = 91;          // separate from those of trial and noise
  constexpr double usual = 0.25, least = 0.05;  // mm
  const BlindTrial trial = *drawBlindTrial({.protocol = protocol, .kinds = kinds}, seed);
  RandomSource random(seed, stream);
  Measurement measurement = *examine(trial.session).measurement;
  const bool isWithin = random.uniform() < 2.0 / 3;
  const double off = usual * random.uniform(0.3, 3);
  measurement.tolerance = std::max(least, std::abs(trial.truth.intersection) + (isWithin ? off : -off));
  return measurement;
}

/// Changes of the verdict of one session under `count` random changes of a single row.
struct Changes {
  int all = 0, other = 0;  ///< changes, and those with another verdict
  int better = 0;          ///< from undecided to accept …
  int unsupported = 0;     ///< … although all readings gave less than `support` for conformity
};

/// The least supporting probability of conformity: 1 − 2 (1 − c) with the coverage c = 95 %.
inline constexpr double support = 0.9;

inline Changes changesOf(const JudgedSession& session, int count, std::uint64_t seed) {
  constexpr std::uint64_t stream = 92;
  RandomSource random(seed, stream);
  Changes changes;
  for (int i = 0; i < count; ++i) {
    const std::size_t arc = random.whole(0, static_cast<int>(session.measurement.arcs.size()) - 1);
    const int rows = static_cast<int>(session.measurement.arcs[arc].sightings.size());
    const std::size_t row = random.whole(0, rows - 1);
    Measurement changed = session.measurement;
    if (i % 2 == 0) {
      changed = without(std::move(changed), arc, row);
    } else {
      Sighting& sighting = changed.arcs[arc].sightings[row];
      Angle& circle = random.uniform() < 0.5 ? sighting.a : sighting.e;
      circle = circle + Angle::fromArcseconds(random.uniform() < 0.5 ? 60 : -60);
    }
    const auto then = judged(std::move(changed));
    ++changes.all;
    if (!then || then->decision.verdict == session.decision.verdict) continue;
    ++changes.other;
    if (session.decision.verdict != Verdict::Undecided || then->decision.verdict != Verdict::Accept) continue;
    ++changes.better;
    changes.unsupported += session.decision.conformance.value_or(0) < support ? 1 : 0;
  }
  return changes;
}

}  // namespace alidade::test
