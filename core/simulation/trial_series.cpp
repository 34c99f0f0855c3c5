#include "core/simulation/trial_series.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/diagnosis/diagnose.h"
#include "core/effects/catalogue.h"
#include "core/session/session_file.h"
#include "core/simulation/each_trial.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

namespace {

Problem about(const std::string& id, const Problem& problem) {
  return {"session " + id + ": " + problem.text()};
}

bool canBeWithheld(const SealedTruth& truth) {
  return truth.visible && *truth.visible >= clearVisibility && (effectById(truth.kind) || truth.statesOwn);
}

/// True if the causes include effects of the user's own, and the session states all of these.
bool statesOwn(const Session& session, const SealedTruth& truth) {
  const auto isOwn = [](const std::string& id) { return id.starts_with(ownPrefix); };
  const auto isStated = [&](const std::string& id) {
    return !isOwn(id) || std::ranges::find(session.ownEffects, id, &ownId) != session.ownEffects.end();
  };
  return std::ranges::any_of(truth.causes, isOwn) && std::ranges::all_of(truth.causes, isStated);
}

Result<ScoredTrial> scored(const TrialCase& trial, bool withheld) {
  const Examined examined = examine(trial.session);
  if (!examined.problems.empty()) return about(trial.seal.id, examined.problems.front());
  const SessionFit fit = fitSession(*examined.measurement);
  const auto diagnosis = diagnose(*examined.measurement, fit);
  if (!diagnosis) return about(trial.seal.id, problemOf(diagnosis.problem()));
  ScoredTrial result{trial.seal, scoreTrial(trial.seal, *diagnosis), std::nullopt};
  if (withheld && canBeWithheld(trial.seal)) {
    const auto without = diagnose(*examined.measurement, fit, {.without = {trial.seal.kind}});
    if (!without) return about(trial.seal.id, problemOf(without.problem()));
    result.wrongWithout = blamesWrongCause(trial.seal, *without);
  }
  return result;
}

Result<std::string> contentOf(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  if (file) content << file.rdbuf();
  if (file && content) return content.str();
  const std::string reason = errno != 0 ? std::strerror(errno) : "it cannot be read";
  return Problem{path.string() + ": " + reason +
                 "; a folder of trials holds truth.json and sessions/*.alidade"};
}

}  // namespace

Result<std::vector<ScoredTrial>> scoreTrials(const TrialSeriesOptions& options,
                                             const std::function<Result<TrialCase>(std::size_t)>& trialAt) {
  const auto scoredAt = [&](std::size_t i) -> Result<ScoredTrial> {
    const Result<TrialCase> trial = trialAt(i);
    if (!trial) return trial.problem();
    return scored(*trial, options.withheld);
  };
  return eachTrial<ScoredTrial>(options.count, options.threads, scoredAt, options.progress);
}

Result<std::vector<ScoredTrial>> scoreDrawnTrials(const TrialSeriesOptions& options,
                                                  const BlindTrialOptions& draw, std::uint64_t seed) {
  return scoreTrials(options, [&](std::size_t i) -> Result<TrialCase> {
    Result<BlindTrial> trial = drawBlindTrial(draw, seed + i);
    if (!trial) return trial.problem();
    return TrialCase{trial->session, trial->seal};
  });
}

Result<std::vector<ScoredTrial>> scoreStoredTrials(const TrialSeriesOptions& options,
                                                   const std::string& folder) {
  const std::filesystem::path root(folder), truthFile = root / "truth.json";
  const Result<std::string> text = contentOf(truthFile);
  if (!text) return text.problem();
  const Result<std::vector<SealedTruth>> truths = readSealedTruths(*text);
  if (!truths) return Problem{truthFile.string() + ": " + truths.problem().text()};
  std::error_code none;
  const std::filesystem::path own = root / "sessions", sessions = is_directory(own, none) ? own : root;
  TrialSeriesOptions all = options;
  all.count = truths->size();
  return scoreTrials(all, [&](std::size_t i) -> Result<TrialCase> {
    SealedTruth truth = (*truths)[i];
    const std::filesystem::path file = sessions / (truth.id + ".alidade");
    Result<Session> read = loadSession(file.string());
    if (!read) return Problem{file.string() + ": " + read.problem().text()};
    Session session = *std::move(read);
    for (const OwnEffect& effect : options.own) takeOwnEffect(session, effect);
    truth.statesOwn = statesOwn(session, truth);
    return TrialCase{std::move(session), std::move(truth)};
  });
}

}  // namespace alidade
