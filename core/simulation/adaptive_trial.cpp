#include "core/simulation/adaptive_trial.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/statistics.h"
#include "core/diagnosis/diagnose.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/guidance/sighting_choice.h"
#include "core/simulation/each_trial.h"
#include "core/simulation/protocol.h"
#include "core/simulation/trial_score.h"
#include "core/simulation/watched_session.h"

namespace alidade {

namespace {

bool isAmong(const std::vector<std::string>& ids, const std::string& id) {
  return std::ranges::find(ids, id) != ids.end();
}

/// True if the group contains a cause of the truth, or its first id is a look-alike of the cause.
bool isThere(const std::vector<std::string>& group, const SealedTruth& truth) {
  if (classOf(truth) == TrialClass::Unknown) return isAmong(group, formId);
  return std::ranges::any_of(truth.causes, [&](const auto& cause) { return isAmong(group, cause); }) ||
         isAmong(truth.lookAlikes, group.front());
}

void score(WatchedRun& run, const SealedTruth& truth) {
  std::size_t found = 0, absent = 0;
  for (const auto* group : {&run.named, &run.alsoNamed})
    if (!group->empty()) ++(isThere(*group, truth) ? found : absent);
  run.isWrong = absent > 0;
  const bool mayBeMissed = classOf(truth) == TrialClass::Faint;
  const std::size_t sought = truth.kind == "two_causes" ? 2 : 1;
  run.isRight = absent == 0 && (found == sought || (found == 0 && mayBeMissed));
}

std::vector<NextSighting> stepsOf(const Protocol& protocol) {
  std::vector<NextSighting> steps;
  for (const int axisDeg : protocol.axes)
    for (const PlannedRow& row : plannedRows(protocol))
      steps.push_back({.axisDeg = axisDeg, .point = row.point, .face = row.face, .round = row.round});
  return steps;
}

/// Reads one session.
class Run {
 public:
  Run(const Protocol& protocol, const Truth& truth, std::uint64_t seed, bool isWatchedToTheEnd = false)
      : m_protocol(protocol),
        m_plan(openPlan(templateOf(protocol))),
        m_session(protocol, truth, seed),
        m_isWatchedToTheEnd(isWatchedToTheEnd) {}

  WatchedRun inOrder() {
    for (const NextSighting& step : stepsOf(m_protocol)) {
      take(step);
      if (look(false) && !m_isWatchedToTheEnd && m_state->enough == Enough::Named) break;
    }
    return std::move(m_run);
  }

  WatchedRun byWorth() {
    const NextSighting first = stepsOf(m_protocol).front();
    take(first);
    while (look() && m_session.sightings() < m_plan.rows && !m_state->ranked.empty()) {
      if (!m_isWatchedToTheEnd && m_state->enough == Enough::Named && close(first)) break;
      if (!m_isWatchedToTheEnd && m_state->enough == Enough::WillNotHelp) break;
      take(m_state->ranked.front());
    }
    return std::move(m_run);
  }

 private:
  const Protocol& m_protocol;
  SightingPlan m_plan;
  WatchedSession m_session;
  WatchedRun m_run;
  std::optional<SessionSoFar> m_state;
  std::optional<NextSighting> m_last;
  bool m_isWatchedToTheEnd, m_isClosed = false;
  std::size_t m_turns = 0;

  void take(const NextSighting& step) {
    const bool begins = !m_last || m_last->axisDeg != step.axisDeg;
    m_run.minutes += minutesOf(m_plan.minutes, {.turnsAxis = m_last && begins,
                                                .sightsZero = begins,
                                                .plungesTelescope = m_last && m_last->face != step.face,
                                                .drivesSlider = begins || m_last->point != step.point});
    if (m_last && begins) ++m_turns;
    m_plan.canTurnAxis = m_turns + 1 < 2 * m_protocol.axes.size();  // as in `openOrder`
    m_session.sight(step.axisDeg, step.round, step.point, step.face);
    ++m_run.sightings;
    m_last = step;
  }

  /// Evaluates the readings so far. Returns false if they determine nothing yet.
  bool look(bool ranks = true) {
    const std::optional<Measurement> measurement = m_session.measurement();
    if (!measurement) return false;
    m_state = sessionSoFar(*measurement, m_plan, ranks);
    if (!m_state) return false;
    m_run.most = std::max(m_run.most, m_state->logEvidence);
    // A name may be withdrawn later; in a session with nothing to name, every name counts.
    if (!m_state->named.empty() || !m_isWatchedToTheEnd) {
      m_run.named = m_state->named;
      m_run.alsoNamed = m_state->alsoNamed;
    }
    if (m_state->sigma)
      m_run.looks.push_back(
          {m_run.sightings, m_run.minutes,
           coverageFactor(measurement->coverage, DegreesOfFreedom::infinite()) * *m_state->sigma});
    return true;
  }

  /// Sights an early place once more and then the zero, so that an effect of time shows. Returns whether a
  /// cause is still named.
  bool close(const NextSighting& first) {
    if (std::exchange(m_isClosed, true)) return true;
    const auto again = std::ranges::find_if(m_state->ranked, [&](const NextSighting& next) {
      return !next.turnsAxis && next.point == first.point && next.face == m_last->face;
    });
    if (again != m_state->ranked.end()) take(*again);
    m_session.sightZero();
    ++m_run.sightings;
    m_run.minutes += minutesOfPointing;
    return look() && m_state->enough == Enough::Named;
  }
};

Result<AdaptiveTrial> trialOf(const Protocol& protocol, const std::vector<std::string>& kinds,
                              std::uint64_t seed) {
  const auto drawn = drawBlindTrial({.protocol = protocol.name, .kinds = kinds}, seed);
  if (!drawn) return drawn.problem();
  AdaptiveTrial trial;
  trial.truth = drawn->seal;
  trial.rows = stepsOf(protocol).size();
  trial.ofProtocol = Run(protocol, drawn->truth, seed).inOrder();
  trial.byWorth = Run(protocol, drawn->truth, seed).byWorth();
  for (WatchedRun* run : {&trial.ofProtocol, &trial.byWorth}) score(*run, trial.truth);
  if (const auto measurement = examine(drawn->session).measurement)
    if (const auto diagnosis = diagnose(*measurement))
      trial.isRightInFull = scoreTrial(drawn->seal, *diagnosis).right;
  return trial;
}

/// A session without a cause, watched to its end.
Result<WatchedRuns> cleanRunsOf(const Protocol& protocol, std::uint64_t seed, bool readsInOrder) {
  const auto drawn = drawBlindTrial({.protocol = protocol.name, .kinds = {"none"}}, seed);
  if (!drawn) return drawn.problem();
  WatchedRuns runs;
  if (readsInOrder) runs.ofProtocol = Run(protocol, drawn->truth, seed, true).inOrder();
  runs.byWorth = Run(protocol, drawn->truth, seed, true).byWorth();
  return runs;
}

}  // namespace

Result<AdaptiveTrials> adaptiveTrials(const AdaptiveTrialOptions& options, const Protocol& protocol,
                                      std::uint64_t seed) {
  if (protocol.circleShift != Angle()) return Problem{"a protocol that turns the circle has a fixed order"};
  std::vector<std::string> effects;
  for (const Effect* effect : soughtEffects()) effects.emplace_back(effect->id);
  std::vector<std::vector<std::string>> kinds(options.count, effects);
  kinds.insert(kinds.end(), options.two, {"two_causes"});
  kinds.insert(kinds.end(), options.unknown, {"unknown"});
  const std::size_t sealed = kinds.size();
  auto withCause = eachTrial<AdaptiveTrial>(
      sealed, options.threads, [&](std::size_t i) { return trialOf(protocol, kinds[i], seed + i); },
      options.progress);
  if (!withCause) return withCause.problem();
  auto clean = eachTrial<WatchedRuns>(
      options.clean, options.threads,
      [&](std::size_t i) { return cleanRunsOf(protocol, seed + sealed + i, options.readsCleanInOrder); },
      [&](std::size_t done) {
        if (options.progress) options.progress(sealed + done);
      });
  if (!clean) return clean.problem();
  return AdaptiveTrials{*std::move(withCause), *std::move(clean)};
}

}  // namespace alidade
