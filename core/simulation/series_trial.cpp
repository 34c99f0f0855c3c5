#include "core/simulation/series_trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <thread>

#include "core/base/file_bytes.h"
#include "core/base/random_source.h"
#include "core/base/threads.h"
#include "core/base/visible_text.h"
#include "core/diagnosis/visibility.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/series/shared_causes/diagnose_series.h"
#include "core/session/session_file.h"
#include "core/simulation/blind_trial.h"
#include "core/simulation/protocol.h"
#include "core/simulation/sealed_truth.h"
#include "core/simulation/simulate.h"
#include "core/simulation/truth_text.h"
#include "core/wording/diagnosis_fault.h"

namespace alidade {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::uint64_t farApart = 1'000'003;  // seeds of the sessions of a series

/// Draws one series, step by step.
class SeriesDraw {
 public:
  explicit SeriesDraw(std::uint64_t seed)
      : m_seed(seed), m_random(seed, stream), m_further(seed, furtherStream) {
    constexpr std::array names{"paper", "paper-slider", "there-and-back", "two-face"};
    m_protocol = protocolByName(names[static_cast<std::size_t>(m_random.whole(0, names.size() - 1))]);
    const auto count = static_cast<std::size_t>(m_random.whole(8, 12));
    for (std::size_t s = 0; s < count; ++s) {
      m_truths.push_back(drawTruth(m_seed * farApart + s));
      m_truths.back().protocol = m_protocol->name;
    }
  }

  Result<SeriesTrial> trial() {
    constexpr double nothing = 0.25, spoiled = 1.0 / 3, foreign = 0.25;
    m_seal.id = std::to_string(m_seed);
    m_seal.protocol = m_protocol->name;
    const bool isEmpty = m_random.uniform() < nothing;
    if (m_further.uniform() < foreign) {
      putUnknown();
      if (!m_seal.visible) return Problem{"nothing of no catalogue shows in series " + m_seal.id};
    } else {
      const Effect* effect = isEmpty ? nullptr : anyEffect();
      layOut(effect ? std::optional(effect->source) : std::nullopt);
      if (effect && !put(*effect)) return Problem{"no effect shows in series " + m_seal.id};
    }
    if (m_random.uniform() < spoiled) spoil();
    SeriesTrial trial{m_seal, {}};
    for (std::size_t s = 0; s < m_truths.size(); ++s) {
      Result<Session> simulated = simulate(*m_protocol, m_truths[s], m_seed * farApart + s);
      if (!simulated) return simulated.problem();
      Session session = *std::move(simulated);
      session.title = "Series " + m_seal.id + ", session " + std::to_string(s + 1);
      session.instrument.serial = m_instruments[s];
      session.device.serial = m_guideways[s];
      trial.sessions.push_back(std::move(session));
    }
    return trial;
  }

 private:
  static constexpr std::uint64_t stream = 5, furtherStream = 6;  // apart from those of single trials
  std::uint64_t m_seed;
  RandomSource m_random, m_further;
  const Protocol* m_protocol = nullptr;
  std::vector<Truth> m_truths;
  std::vector<std::string> m_instruments, m_guideways;
  SeriesSeal m_seal;

  const Effect* anyEffect() {
    const std::vector<const Effect*> effects = soughtEffects();
    while (true) {
      const Effect* effect =
          effects[static_cast<std::size_t>(m_random.whole(0, static_cast<int>(effects.size()) - 1))];
      const bool isShared =
          effect->source == ErrorSource::Instrument || effect->source == ErrorSource::Guideway;
      if (isShared && effect->response == Response::Linear && shows(*effect)) return effect;
    }
  }

  /// In one session of this plan at all, at a few plausible sizes.
  bool shows(const Effect& effect) const {
    constexpr double least = 1;
    const std::optional<double> visible = visibleIn(0, effect, 0.7);
    return visible && *visible > least;
  }

  std::optional<double> visibleIn(std::size_t s, const Effect& effect, double angle) const {
    Truth truth = m_truths[s];
    setSize(truth, effect, angle, 1);
    const Result<Session> perfect = simulateWithoutNoise(*m_protocol, truth, m_seed * farApart + s);
    if (!perfect) return std::nullopt;
    const auto found = visibilityOf(*examine(*perfect).measurement, std::string(effect.id));
    return found ? std::optional(found->sigma) : std::nullopt;
  }

  static void setSize(Truth& truth, const Effect& effect, double angle, double size) {
    const auto& parameters = effect.parameters;
    const double first = parameters.size() == 1 ? (std::cos(angle) < 0 ? -1 : 1) : std::cos(angle);
    truth.effects.push_back({parameters[0].term, size * first * parameters[0].plausible});
    if (parameters.size() > 1)
      truth.effects.push_back({parameters[1].term, size * std::sin(angle) * parameters[1].plausible});
  }

  /// Which instrument reads which guideway in each session.
  void layOut(std::optional<ErrorSource> source) {
    const bool crossed = m_random.uniform() < 0.4;
    const bool ofInstrument = source == ErrorSource::Instrument;
    for (std::size_t s = 0; s < m_truths.size(); ++s) {
      const auto number = [&](std::size_t of) { return std::to_string(s % of + 1); };
      if (crossed) {
        m_instruments.push_back("T-" + number(2));
        m_guideways.push_back("G-" + number(3));
        continue;
      }
      m_instruments.push_back(ofInstrument ? "T-1" : "T-" + number(4));
      m_guideways.push_back(source != ErrorSource::Guideway ? "G-" + std::to_string(s + 1) : "G-1");
    }
    if (!source || source == ErrorSource::Time) return;
    m_seal.owner = ofInstrument ? CauseOwner::Instrument : CauseOwner::Guideway;
    m_seal.serial = ofInstrument ? "T-1" : "G-1";
  }

  /// In all sessions of its owner, as large as makes it visible by what is drawn; false where it would have
  /// to be far larger than plausible.
  bool put(const Effect& effect) {
    constexpr double least = 6, most = 10, mostPlausible = 6;
    const double angle = m_random.uniform(0, 2 * std::numbers::pi), target = m_random.uniform(least, most);
    m_seal.kind = effect.id;
    const auto& serials = m_seal.owner == CauseOwner::Instrument ? m_instruments : m_guideways;
    double square = 0;
    for (std::size_t s = 0; s < m_truths.size(); ++s)
      if (serials[s] == m_seal.serial) square += std::pow(visibleIn(s, effect, angle).value_or(0), 2);
    if (!(target < mostPlausible * std::sqrt(square))) return false;
    for (std::size_t s = 0; s < m_truths.size(); ++s)
      if (serials[s] == m_seal.serial) setSize(m_truths[s], effect, angle, target / std::sqrt(square));
    m_seal.visible = target;
    return true;
  }

  /// Whose a disturbance of no catalogue is.
  static ErrorSource sourceOf(const Truth& truth) {
    using enum ForeignEffect::Kind;
    if (!truth.foreign) return ErrorSource::Guideway;
    switch (truth.foreign->kind) {
      case LocalDent:
      case HighWarp:
        return ErrorSource::Guideway;
      case CirclePeriods:
      case Refraction:
      case Backlash:
        return ErrorSource::Instrument;
      case Settling:
      case DistanceRamp:
        break;
    }
    return ErrorSource::Time;
  }

  /// One that all sessions of its owner share, what the time brings in all alike. Of sessions without noise
  /// how far it shows, and how far beyond whatever effect of the catalogue is nearest in each, is in
  /// proportion to its size.
  void putUnknown() {
    constexpr double least = 8, most = 16, beyond = 6, mostSize = 300;
    Truth drawn = m_truths.front();
    putForeign(drawn, m_further);
    const ErrorSource source = sourceOf(drawn);
    layOut(source);
    const auto has = [&](std::size_t s) {
      if (m_seal.owner == CauseOwner::Time) return true;
      return (m_seal.owner == CauseOwner::Instrument ? m_instruments : m_guideways)[s] == m_seal.serial;
    };
    double square = 0, nearest = 0;
    for (std::size_t s = 0; s < m_truths.size(); ++s) {
      if (!has(s)) continue;
      m_truths[s].foreign = drawn.foreign;
      m_truths[s].harmonic = drawn.harmonic;
      const std::optional<Visibility> shown = shownIn(s);
      square += std::pow(shown ? shown->sigma : 0, 2);
      nearest += std::pow(shown ? shown->nearest : 0, 2);
    }
    const double target = m_further.uniform(least, most);
    const double size = (m_further.uniform() < 0.5 ? -1 : 1) * target / std::max(std::sqrt(square), 1e-9);
    if (std::abs(size) > mostSize || std::abs(size) * std::sqrt(nearest) < beyond) return;
    for (std::size_t s = 0; s < m_truths.size(); ++s)
      if (has(s)) setForeignSize(m_truths[s], size);
    m_seal.kind = kindOf(m_truths[firstWith(has)]);
    m_seal.visible = target;
  }

  template <typename Has>
  std::size_t firstWith(const Has& has) const {
    std::size_t s = 0;
    while (!has(s)) ++s;
    return s;
  }

  std::optional<Visibility> shownIn(std::size_t s) const {
    const Result<Session> perfect = simulateWithoutNoise(*m_protocol, m_truths[s], m_seed * farApart + s);
    if (!perfect) return std::nullopt;
    const auto found = visibilityOf(*examine(*perfect).measurement, {});
    return found ? std::optional(*found) : std::nullopt;
  }

  /// By a knock that nobody overlooks, or by a session that scatters as a whole.
  void spoilFurther(Truth& truth) {
    const auto step = [&] {
      return Angle::fromArcseconds((m_further.uniform() < 0.5 ? -1 : 1) * m_further.uniform(60, 600));
    };
    if (m_further.uniform() < 0.5) {
      truth.noiseFactor = m_further.uniform(2, 5);
      m_seal.spoiledBy = noiseId;
      return;
    }
    truth.jump = {.moment = m_further.uniform(0.1, 0.9), .horizontal = step(), .vertical = step()};
    m_seal.spoiledBy = jumpId;
  }

  void spoil() {
    const auto s = static_cast<std::size_t>(m_random.whole(0, static_cast<int>(m_truths.size()) - 1));
    m_seal.spoiled = s;
    if (m_further.uniform() < 0.5) return spoilFurther(m_truths[s]);
    const double sign = m_random.uniform() < 0.5 ? -1 : 1;
    const int way = m_random.whole(0, 2);
    if (way == 0) {
      const std::vector<PlannedRow> rows = plannedRows(*m_protocol);
      const PlannedRow& row = rows[rows.size() / 2];
      m_truths[s].grossErrors = {{.axisDeg = 0,
                                  .round = row.round,
                                  .point = row.point,
                                  .face = row.face,
                                  .horizontal = Angle::fromArcseconds(sign * m_random.uniform(60, 300)),
                                  .vertical = {}}};
      m_seal.spoiledBy = grossErrorId;
    } else if (way == 1) {
      m_truths[s].jump = {.moment = m_random.uniform(0.2, 0.8),
                          .horizontal = Angle::fromArcseconds(sign * m_random.uniform(30, 60)),
                          .vertical = Angle::fromArcseconds(m_random.uniform(30, 60))};
      m_seal.spoiledBy = jumpId;
    } else {
      spoilByEffect(s);
    }
  }

  /// By one that shows by 12 σ in this session, and is not the one shared.
  void spoilByEffect(std::size_t s) {
    constexpr double visible = 12, mostPlausible = 8;
    for (int tries = 0; tries < 50; ++tries) {
      const Effect* effect = anyEffect();
      const double angle = m_random.uniform(0, 2 * std::numbers::pi);
      const double one = visibleIn(s, *effect, angle).value_or(0);
      if (effect->id == m_seal.kind || !(visible < mostPlausible * one)) continue;
      // What the session shares is put in already, and `visibleIn` has seen it.
      Truth clean = m_truths[s];
      setSize(clean, *effect, angle, visible / std::max(one, 1e-9));
      m_truths[s] = clean;
      m_seal.spoiledBy = effect->id;
      return;
    }
    m_seal.spoiled.reset();
  }
};

bool blames(const Cause& cause, const std::string& id) {
  const auto& alike = cause.indistinguishableFrom;
  return cause.effect == id || std::ranges::find(alike, id) != alike.end();
}

Result<SeriesDiagnosis> diagnosed(const std::string& id, const std::vector<Session>& sessions,
                                  std::size_t threads) {
  std::vector<SeriesSession> members;
  for (const Session& session : sessions) {
    Examined examined = examine(session);
    if (!examined.problems.empty())
      return Problem{"series " + id + ": " + session.title + ": " + examined.problems.front().text()};
    members.push_back(seriesSession(session.title, session, *std::move(examined.measurement)));
  }
  auto outcome = diagnoseSeries(members, {.threads = threads, .withSessions = false});
  if (!outcome) return Problem{"series " + id + ": " + problemOf(outcome.problem()).text()};
  return (*std::move(outcome)).diagnosis;
}

/// Each of so many, several at once.
template <typename Made>
Result<std::vector<ScoredSeries>> scoreEach(std::size_t count, std::size_t threads, const Made& trialAt) {
  std::vector<std::optional<Result<ScoredSeries>>> results(count);
  const std::size_t all = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  doEach(std::clamp<std::size_t>(count, 1, all), count, [&](std::size_t i) {
    const Result<SeriesTrial> trial = trialAt(i);
    if (!trial) {
      results[i] = Result<ScoredSeries>(trial.problem());
      return;
    }
    const Result<SeriesDiagnosis> diagnosis = diagnosed(trial->seal.id, trial->sessions, 1);
    results[i] = diagnosis ? Result<ScoredSeries>(scoreSeries(trial->seal, *diagnosis))
                           : Result<ScoredSeries>(diagnosis.problem());
  });
  std::vector<ScoredSeries> scored;
  for (auto& result : results) {
    if (!*result) return result->problem();
    scored.push_back(**std::move(result));
  }
  return scored;
}

Result<Json> truthsOf(const std::string& folder) {
  const std::string file = (fs::path(folder) / "truth.json").string();
  const Result<std::string> text = readFile(file);
  if (!text) return Problem{file + ": " + text.problem().text() + "; a folder of series holds truth.json"};
  Json json = Json::parse(*text, nullptr, false);
  if (!json.is_object())
    return Problem{file + ": it is no JSON object: give one of series with their truths"};
  return json;
}

/// Without one that the truth states, that of the effect; of no catalogue by what the scenario says.
CauseOwner ownerIn(const Json& entry, const std::string& kind) {
  const auto says = [&](const char* key, std::string_view what) {
    return entry.contains(key) && entry[key].is_string() &&
           entry[key].get<std::string>().find(what) != std::string::npos;
  };
  for (const CauseOwner owner : {CauseOwner::Instrument, CauseOwner::Guideway})
    if (says("shared", nameOf(owner)) || says("scenario", nameOf(owner))) return owner;
  const Effect* effect = effectById(kind);
  if (!effect || entry.contains("shared")) return CauseOwner::Time;
  if (effect->source == ErrorSource::Instrument) return CauseOwner::Instrument;
  return effect->source == ErrorSource::Guideway ? CauseOwner::Guideway : CauseOwner::Time;
}

SeriesSeal sealOf(const std::string& id, const Json& entry) {
  SeriesSeal seal{.id = id, .kind = entry["kind"].get<std::string>()};
  seal.owner = ownerIn(entry, seal.kind);
  for (const char* key : {"plan", "protocol"})
    if (entry.contains(key) && entry[key].is_string()) seal.protocol = entry[key];
  if (entry.contains("visible_sigma_together") && entry["visible_sigma_together"].is_number())
    seal.visible = entry["visible_sigma_together"];
  return seal;
}

}  // namespace

Result<SeriesTrial> drawSeriesTrial(std::uint64_t seed) {
  constexpr std::uint64_t again = 1'000'000'007;  // where a plan cannot show what was drawn
  constexpr int tries = 20;
  for (std::uint64_t i = 0;; ++i) {
    Result<SeriesTrial> drawn = SeriesDraw(seed + i * again).trial();
    if (!drawn && i < tries) continue;
    if (!drawn) return drawn.problem();
    SeriesTrial trial = *std::move(drawn);
    trial.seal.id = std::to_string(seed);
    return trial;
  }
}

ScoredSeries scoreSeries(const SeriesSeal& seal, const SeriesDiagnosis& diagnosis) {
  ScoredSeries scored{.seal = seal, .sessions = diagnosis.sessions.size(), .answer = {}};
  const SharedCause* first = nullptr;
  for (const SharedCause& cause : diagnosis.causes) {
    const bool isShared = cause.owner != CauseOwner::Time || !cause.sizes.empty();
    if (!isShared) continue;
    scored.isNoiseOfAll |= cause.cause.effect == noiseId && cause.sessions.size() > 1;
    if (!first) first = &cause;
    scored.answer += (scored.answer.empty() ? "" : ", ") + cause.cause.effect + " (" +
                     std::string(nameOf(cause.owner)) + (cause.serial.empty() ? "" : " " + cause.serial) +
                     ")";
  }
  const bool isUnknown = diagnosis.verdict == DiagnosisVerdict::NotInCatalogue;
  scored.isAlarm = first != nullptr || isUnknown;
  if (isUnknown) scored.answer = std::string(nameOf(diagnosis.verdict)) + (first ? ", " : "") + scored.answer;
  if (scored.answer.empty()) scored.answer = "nothing shared";
  for (const SeriesMember& member : diagnosis.sessions)
    scored.namedAlone += !member.causesAlone.empty() && blames(member.causesAlone.front(), seal.kind) ? 1 : 0;
  if (isOfNoCatalogue(seal.kind)) {
    scored.isNamed = scored.isFirst = scored.isOwnerRight = isUnknown && !first;
  } else if (first && !isUnknown) {
    scored.isFirst = first->cause.effect == seal.kind;
    scored.isNamed = blames(first->cause, seal.kind);
    scored.isOwnerRight = first->owner == seal.owner && (seal.serial.empty() || first->serial == seal.serial);
  }
  if (seal.spoiled)
    for (const SeriesMember& member : diagnosis.sessions)
      scored.isSpoilerFound = scored.isSpoilerFound || (member.file == *seal.spoiled && !member.own.empty());
  return scored;
}

Result<std::vector<ScoredSeries>> scoreDrawnSeries(std::size_t count, std::uint64_t seed,
                                                   std::size_t threads) {
  return scoreEach(count, threads, [&](std::size_t i) { return drawSeriesTrial(seed + i); });
}

Result<std::vector<ScoredSeries>> scoreStoredSeries(const std::string& folder, std::size_t threads) {
  const Result<Json> truths = truthsOf(folder);
  if (!truths) return truths.problem();
  std::vector<std::pair<std::string, Json>> entries;
  for (const auto& [id, entry] : truths->items()) {
    if (isTruthOfSeries(entry)) entries.emplace_back(id, entry);
  }
  return scoreEach(entries.size(), threads, [&](std::size_t i) -> Result<SeriesTrial> {
    const auto& [id, entry] = entries[i];
    SeriesTrial trial{sealOf(id, entry), {}};
    const char* sessions = entry.contains("sessions") ? "sessions" : "intersection_mm";
    for (const auto& [session, truth] : entry[sessions].items()) {
      const std::string file = (fs::path(folder) / id / (session + ".alidade")).string();
      Result<Session> read = loadSession(file);
      if (!read) return Problem{file + ": " + read.problem().text()};
      trial.sessions.push_back(*std::move(read));
    }
    return trial;
  });
}

bool holdsSeries(const std::string& folder) {
  const Result<Json> truths = truthsOf(folder);
  return truths && std::ranges::any_of(*truths, isTruthOfSeries);
}

bool holdsSessions(const std::string& folder) {
  const Result<Json> truths = truthsOf(folder);
  return !truths || !std::ranges::all_of(*truths, isTruthOfSeries) || truths->empty();
}

}  // namespace alidade
