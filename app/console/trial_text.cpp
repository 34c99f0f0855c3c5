#include "app/console/trial_text.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/console/text_layout.h"
#include "core/answers/json_text.h"
#include "core/base/number_text.h"
#include "core/wording/effect_name.h"

namespace alidade::console {

namespace {

using Rows = std::vector<std::vector<std::string>>;
using Json = nlohmann::ordered_json;

std::string percent(const Tally& tally) {
  if (tally.count == 0) return "-";
  return fixedText(100.0 * static_cast<double>(tally.hits) / static_cast<double>(tally.count), 1) + " %";
}

std::vector<std::string> row(const std::string& name, const Tally& tally) {
  return {"  " + name, std::to_string(tally.hits) + "/" + std::to_string(tally.count), percent(tally)};
}

std::string scoresText(const TrialSummary& summary) {
  Rows rows;
  for (const auto& [trialClass, tally] : summary.right)
    rows.push_back(row(std::string(nameOf(trialClass)), tally));
  return "\nRight answers\n" + alignedColumns(rows);
}

std::string checksText(const TrialSummary& summary) {
  Rows rows;
  const auto offer = [&](const std::string& name, const Tally& tally) {
    if (tally.count > 0) rows.push_back(row(name, tally));
  };
  offer("false alarms where nothing is wrong", summary.falseAlarms);
  offer("reduced χ² back to noise once the cause is added", summary.backToNoise);
  offer("true Δd within Δd ± U once the cause is added", summary.covered);
  offer("wrong single cause with the right one withheld", summary.wrongWithout);
  return rows.empty() ? "" : "\nChecks\n" + alignedColumns(rows);
}

std::string range(const DetectionBin& bin) {
  const std::string from = fixedText(bin.from, 0);
  return std::isinf(bin.to) ? from + " σ and more" : from + " to " + fixedText(bin.to, 0) + " σ";
}

std::string detectionText(const TrialSummary& summary) {
  if (summary.detection.empty()) return "";
  Rows rows{{"  shows by", "trials", "gap found", "truth named"}};
  for (const DetectionBin& bin : summary.detection)
    rows.push_back(
        {"  " + range(bin), std::to_string(bin.detected.count), percent(bin.detected), percent(bin.named)});
  return "\nEffects by how far they show in the readings\n" + alignedColumns(rows);
}

std::string confusionText(const TrialSummary& summary) {
  std::string text = "\nTruth: what was answered\n";
  for (const auto& [kind, answers] : summary.confusion) {
    std::string line = "  " + causeName(kind) + ":";
    for (const auto& [answer, count] : answers)
      line += " " + causeName(answer) + " " + std::to_string(count) + ";";
    line.pop_back();
    text += paragraph(line, 4);
  }
  return text;
}

/// "12/15", or "-" if not applicable.
std::string countText(const Tally& tally) {
  return tally.count == 0 ? "-" : std::to_string(tally.hits) + "/" + std::to_string(tally.count);
}

std::string kindsText(const TrialSummary& summary) {
  Rows rows{{"  kind", "right", "named", "quiet", "after covers Δd", "measured covers Δd"}};
  for (const auto& [kind, tally] : summary.kinds)
    rows.push_back({"  " + causeName(kind), countText(tally.right), countText(tally.named),
                    countText(tally.quiet), countText(tally.after), countText(tally.measured)});
  return "\nBy kind of truth\n" + alignedColumns(rows);
}

/// The trials with a wrong diagnosis.
std::string missedText(const std::vector<ScoredTrial>& trials) {
  constexpr std::size_t most = 40;
  std::string text;
  std::size_t missed = 0;
  for (const ScoredTrial& trial : trials) {
    if (trial.score.right || ++missed > most) continue;
    text +=
        paragraph("  " + trial.truth.id + " (" + trial.truth.protocol + "): " + causeName(trial.truth.kind) +
                      (trial.truth.visible ? ", " + fixedText(*trial.truth.visible, 1) + " σ" : "") +
                      ", taken for " + causeName(trial.score.answer),
                  4);
  }
  if (missed > most) text += "  and " + std::to_string(missed - most) + " more\n";
  return missed > 0 ? "\nMissed\n" + text : "";
}

Json tallyJson(const Tally& tally) {
  return {{"hits", tally.hits}, {"count", tally.count}};
}

template <typename T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json scoredJson(const ScoredTrial& trial) {
  return {{"id", trial.truth.id},
          {"kind", trial.truth.kind},
          {"causes", trial.truth.causes},
          {"protocol", trial.truth.protocol},
          {"visible_sigma", orNull(trial.truth.visible)},
          {"look_alikes", trial.truth.lookAlikes},
          {"class", nameOf(trial.score.trialClass)},
          {"answer", trial.score.answer},
          {"right", trial.score.right},
          {"detected", trial.score.detected},
          {"named", trial.score.named},
          {"covered", orNull(trial.score.covered)},
          {"covered_after", orNull(trial.score.coveredAfter)},
          {"covered_measured", orNull(trial.score.coveredMeasured)},
          {"back_to_noise", orNull(trial.score.backToNoise)},
          {"wrong_without", orNull(trial.wrongWithout)}};
}

}  // namespace

std::string trialText(const std::vector<ScoredTrial>& trials, const TrialSummary& summary) {
  return std::to_string(summary.count) + " blind trials\n" + scoresText(summary) + checksText(summary) +
         detectionText(summary) + kindsText(summary) + confusionText(summary) + missedText(trials);
}

std::string trialJson(const std::vector<ScoredTrial>& trials, const TrialSummary& summary) {
  Json right = Json::object(), kinds = Json::object(), detection = Json::array(), list = Json::array();
  for (const auto& [kind, tally] : summary.kinds)
    kinds[kind] = {{"right", tallyJson(tally.right)},
                   {"named", tallyJson(tally.named)},
                   {"quiet", tallyJson(tally.quiet)},
                   {"covered_after", tallyJson(tally.after)},
                   {"covered_measured", tallyJson(tally.measured)}};
  for (const auto& [trialClass, tally] : summary.right)
    right[std::string(nameOf(trialClass))] = tallyJson(tally);
  for (const DetectionBin& bin : summary.detection)
    detection.push_back({{"from_sigma", bin.from},
                         {"to_sigma", std::isinf(bin.to) ? Json() : Json(bin.to)},
                         {"detected", tallyJson(bin.detected)},
                         {"named", tallyJson(bin.named)}});
  for (const ScoredTrial& trial : trials) list.push_back(scoredJson(trial));
  Json json = {{"count", summary.count},
               {"right", right},
               {"false_alarms", tallyJson(summary.falseAlarms)},
               {"back_to_noise", tallyJson(summary.backToNoise)},
               {"covered", tallyJson(summary.covered)},
               {"wrong_without", tallyJson(summary.wrongWithout)},
               {"kinds", kinds},
               {"detection", detection},
               {"confusion", summary.confusion},
               {"trials", list}};
  return answerText(std::move(json));
}

}  // namespace alidade::console
