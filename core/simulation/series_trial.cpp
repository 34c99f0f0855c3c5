#include "core/simulation/series_trial.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/file_bytes.h"
#include "core/base/visible_text.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/series/shared_causes/diagnose_series.h"
#include "core/session/session_file.h"
#include "core/simulation/each_trial.h"
#include "core/simulation/sealed_truth.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

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

/// Draws or loads `count` trials and scores them, several in parallel.
template <typename Made>
Result<std::vector<ScoredSeries>> scoreEach(std::size_t count, std::size_t threads, const Made& trialAt) {
  return eachTrial<ScoredSeries>(count, threads, [&](std::size_t i) -> Result<ScoredSeries> {
    const Result<SeriesTrial> trial = trialAt(i);
    if (!trial) return trial.problem();
    const Result<SeriesDiagnosis> diagnosis = diagnosed(trial->seal.id, trial->sessions, 1);
    if (!diagnosis) return diagnosis.problem();
    return scoreSeries(trial->seal, *diagnosis);
  });
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

/// The owner that `shared` or `scenario` names. If none is named and `shared` is missing, the owner of
/// effects of this kind; else `Time`.
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
