#include "core/series/shared_causes/diagnose_series.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <optional>

#include "core/base/threads.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/session_evidence.h"
#include "core/effects/cause_ids.h"
#include "core/series/shared_causes/offered_effects.h"
#include "core/series/shared_causes/series_conclusion.h"
#include "core/session/entry.h"
#include "core/session/other_circle.h"
#include "core/session/readings_digest.h"

namespace alidade {

namespace {

/// `usable` in the order of measurement if all these sessions have a date; else in the order given.
std::vector<std::size_t> inOrder(const std::vector<SeriesSession>& sessions,
                                 const std::vector<std::size_t>& usable) {
  std::vector<std::size_t> order = usable;
  const auto day = [&](std::size_t s) { return dayOf(sessions[s].measuredOn); };
  if (std::ranges::all_of(order, [&](std::size_t s) { return day(s).has_value(); }))
    std::ranges::stable_sort(order, {}, [&](std::size_t s) { return *day(s); });
  return order;
}

std::vector<SessionOwners> ownersOf(const std::vector<SeriesSession>& sessions,
                                    const std::vector<std::size_t>& order) {
  std::vector<SessionOwners> owners;
  std::vector<double> days;
  for (const std::size_t s : order) {
    owners.push_back({sessions[s].instrument, sessions[s].guideway, 0, sessions[s].measurement.own.get()});
    if (const auto day = dayOf(sessions[s].measuredOn))
      days.push_back(static_cast<double>(day->time_since_epoch().count()));
  }
  const bool dated = days.size() == order.size() && days.back() > days.front();
  for (std::size_t i = 0; i < owners.size(); ++i)
    owners[i].time = dated ? (days[i] - days.front()) / (days.back() - days.front())
                           : static_cast<double>(i) / std::max(1.0, static_cast<double>(order.size()) - 1);
  return owners;
}

/// For each session the first one with the same readings.
std::vector<std::size_t> firstsOf(const std::vector<SeriesSession>& sessions) {
  std::vector<std::string> digests;
  for (const SeriesSession& session : sessions) digests.push_back(session.readings);
  return firstsAlike(digests);
}

bool haveBothCircles(const std::vector<SeriesSession>& sessions) {
  return std::ranges::any_of(sessions, [&](const SeriesSession& session) {
    return session.measurement.verticalCircle != sessions.front().measurement.verticalCircle;
  });
}

void noteCopy(SeriesOutcome& outcome, const std::vector<SeriesSession>& sessions, std::size_t copy,
              std::size_t first) {
  const auto fileOf = [&](std::size_t s) {
    return sessions[s].file.empty() ? sessions[s].name : sessions[s].file;
  };
  outcome.copies.emplace_back(copy, first);
  outcome.diagnosis.copies.push_back({fileOf(copy), fileOf(first)});
}

/// The columns of the effects in these sessions; of sessions with the same readings only the first counts.
std::shared_ptr<const SharedColumns> columnsFor(const std::vector<SeriesSession>& sessions,
                                                const std::vector<std::size_t>& firsts) {
  std::vector<std::shared_ptr<const OwnEffects>> own;
  for (std::size_t s = 0; s < sessions.size(); ++s)
    if (firsts[s] == s) own.push_back(sessions[s].measurement.own);
  return std::make_shared<const SharedColumns>(own);
}

/// Drops from `options.without` the user's own effects that other sessions have but this session has not.
DiagnosisOptions optionsFor(DiagnosisOptions options, const SeriesSession& session,
                            const std::vector<SeriesSession>& sessions) {
  std::erase_if(options.without, [&](const std::string& id) {
    return !isDiagnosable(id, session.measurement) &&
           std::ranges::any_of(
               sessions, [&](const SeriesSession& other) { return isDiagnosable(id, other.measurement); });
  });
  return options;
}

/// Reports progress, one call at a time.
class Progress {
 public:
  Progress(const SeriesOptions& options, std::size_t all) : m_report(options.progress), m_all(all) {}
  void step() {
    if (!m_report) return;
    const std::scoped_lock lock(m_mutex);
    m_report(++m_done, m_all);
  }

 private:
  const std::function<void(std::size_t, std::size_t)>& m_report;
  std::mutex m_mutex;
  std::size_t m_all, m_done = 0;
};

}  // namespace

SeriesSession seriesSession(std::string name, const Session& session, Measurement measurement) {
  std::string readings = readingsDigest(session, measurement);
  return {std::move(name),     session.measuredOn,    session.instrument.name, session.instrument.serial,
          session.device.name, session.device.serial, std::move(measurement),  std::move(readings)};
}

Result<SeriesOutcome, DiagnosisFault> diagnoseSeries(const std::vector<SeriesSession>& sessions,
                                                     const SeriesOptions& options,
                                                     const std::stop_token& stop) {
  if (haveBothCircles(sessions)) {
    std::vector<SeriesSession> alike = sessions;
    for (SeriesSession& session : alike)
      session.measurement = withZenithCircle(std::move(session.measurement));
    if (!haveBothCircles(alike)) {
      auto found = diagnoseSeries(alike, options, stop);
      if (!found) return found;
      SeriesOutcome outcome = *std::move(found);
      outcome.diagnosis.hasBothCircles = true;
      return outcome;
    }
  }
  const DiagnosisFault stopped = Stopped{};
  const DiagnosisOptions alone{.without = options.without};
  const std::size_t threads = threadsOrAll(options.threads);
  Progress progress(options, sessions.size() * (options.withSessions ? 2 : 1));
  std::vector<std::optional<Result<SessionEvidence, DiagnosisFault>>> found(sessions.size());
  const std::vector<std::size_t> firsts = firstsOf(sessions);
  const std::shared_ptr<const SharedColumns> columns = columnsFor(sessions, firsts);
  doEach(threads, sessions.size(), [&](std::size_t s) {
    if (firsts[s] == s)
      found[s] = evidenceOf(sessions[s].measurement, columns, optionsFor(alone, sessions[s], sessions), stop);
    progress.step();
  });
  if (stop.stop_requested()) return stopped;

  SeriesOutcome outcome;
  std::vector<std::size_t> usable;
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    if (firsts[s] != s) continue;
    if (*found[s])
      usable.push_back(s);
    else
      outcome.unusable.emplace_back(s, found[s]->problem());
  }
  if (usable.empty()) {
    if (outcome.unusable.empty()) return DiagnosisFault(NoModel{});
    return outcome.unusable.front().second;
  }
  const std::vector<std::size_t> order = inOrder(sessions, usable);
  std::vector<SessionEvidence> evidence;
  std::vector<std::string> names;
  for (const std::size_t s : order) {
    evidence.push_back(**std::move(found[s]));
    names.push_back(sessions[s].name);
  }
  SeriesConclusion conclusion =
      concludeSeries(evidence, ownersOf(sessions, order), names, options.without, stop);
  if (stop.stop_requested()) return stopped;
  outcome.diagnosis = std::move(conclusion.diagnosis);
  for (std::size_t s = 0; s < sessions.size(); ++s)
    if (firsts[s] != s) noteCopy(outcome, sessions, s, firsts[s]);
  outcome.diagnosis.sessions.resize(order.size());
  doEach(threads, order.size(), [&](std::size_t i) {
    const SeriesSession& session = sessions[order[i]];
    SeriesMember& member = outcome.diagnosis.sessions[i];
    member.name = session.name;
    member.measuredOn = session.measuredOn;
    member.instrumentName = session.instrumentName;
    member.instrument = session.instrument;
    member.guidewayName = session.guidewayName;
    member.guideway = session.guideway;
    member.file = order[i];
    member.alone = evidence[i].verdict;
    member.causesAlone = evidence[i].causes;
    member.shared = conclusion.known[i];
    for (const std::string& id : conclusion.own[i]) {
      const auto same = std::ranges::find(evidence[i].causes, id, &Cause::effect);
      Cause cause = same != evidence[i].causes.end() ? *same : Cause{.effect = id};
      cause.probability = conclusion.ownChance[i];
      member.own.push_back(std::move(cause));
    }
    if (!options.withSessions) return;
    Measurement measurement = session.measurement;
    measurement.known.insert(measurement.known.end(), member.shared.begin(), member.shared.end());
    auto diagnosis = diagnose(measurement, optionsFor(alone, session, sessions), stop);
    if (diagnosis) member.diagnosis = *std::move(diagnosis);
    progress.step();
  });
  if (stop.stop_requested()) return stopped;
  addOfferedEffects(outcome.diagnosis);
  for (const SeriesMember& member : outcome.diagnosis.sessions) {
    if (member.instrument.empty()) ++outcome.diagnosis.withoutInstrument;
    if (member.guideway.empty()) ++outcome.diagnosis.withoutGuideway;
  }
  return outcome;
}

}  // namespace alidade
