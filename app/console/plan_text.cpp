#include "app/console/guidance_text.h"

#include <nlohmann/json.hpp>

#include "app/console/text_layout.h"
#include "core/answers/json_parts.h"
#include "core/answers/json_text.h"
#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/effects/catalogue.h"
#include "core/statement/next_measures.h"
#include "core/wording/effect_name.h"
#include "core/wording/measure.h"

namespace alidade::console {

namespace {

using Rows = std::vector<std::vector<std::string>>;
using Json = nlohmann::ordered_json;

std::string visibilityText(const PlannedEffect& effect) {
  const std::string most = fixedText(effect.mostVisible, 1);
  if (effect.mostVisible - effect.leastVisible < 0.05) return most;
  return fixedText(effect.leastVisible, 1) + "…" + most;
}

/// The influence on Δd in mm; "none" if the plan has no Δd.
std::string influenceText(const PlanReview& review, const PlannedEffect& effect) {
  return review.intersection ? fixedText(effect.influence, 4) : "none";
}

std::string effectsText(const PlanReview& review) {
  Rows rows{{"  effect", "plausible", "shows by (σ)", "moves Δd by (mm)", ""}};
  for (const PlannedEffect& effect : review.effects)
    rows.push_back({"  " + causeName(effect.effect), plausibleSizeText(effect.effect), visibilityText(effect),
                    influenceText(review, effect), effect.undetectable ? "undetectable" : ""});
  return "\nEffects of plausible size\n" + alignedColumns(rows);
}

std::string lookAlikesText(const PlanReview& review) {
  std::string text;
  for (const PlannedEffect& effect : review.effects) {
    if (effect.lookAlikes.empty()) continue;
    std::vector<std::string> names;
    for (const LookAlike& other : effect.lookAlikes) names.push_back(causeName(other.effect));
    text += paragraph("  " + causeName(effect.effect) + ": " + listed(names), 4);
  }
  return text.empty() ? "\nAll detectable effects can be distinguished.\n"
                      : "\nDetectable effects that cannot be distinguished from others\n" + text;
}

Json effectJson(const PlanReview& review, const PlannedEffect& effect, const Measurement& measurement) {
  Json sizes = Json::array(), alike = Json::array();
  for (const EffectParameter& parameter : effectById(effect.effect, measurement)->parameters)
    sizes.push_back({{"name", parameter.name}, {"value", parameter.plausible}, {"unit", parameter.unit}});
  for (const LookAlike& other : effect.lookAlikes)
    alike.push_back(
        {{"effect", other.effect}, {"cosine", other.cosine}, {"difference_sigma", other.difference}});
  return {{"effect", effect.effect},
          {"plausible", sizes},
          {"visible_sigma", {{"least", effect.leastVisible}, {"most", effect.mostVisible}}},
          {"look_alikes", alike},
          {"influence_mm", review.intersection ? Json(effect.influence) : Json()},
          {"visible_sigma_there", effect.visibleThere},
          {"unseen", effect.undetectable}};
}

}  // namespace

std::string planText(const std::string& session, const PlanReview& review,
                     const std::vector<Finding>& findings, const SessionEffort& effort) {
  std::string text = heading(session) + "\n" + counted(review.readings, "reading") + " of circles and slider";
  if (const auto& estimate = review.intersection)
    text += "; with the stated noise, u of Δd, fit only, would be " + fixedText(estimate->sigma, 4) + " mm.";
  return text + "\n" + effectsText(review) + lookAlikesText(review) +
         statementText(planAdvice(review, effort)) + findingsText(findings);
}

std::string planJson(const std::string& session, const PlanReview& review,
                     const std::vector<Finding>& findings, const Measurement& measurement,
                     const std::string& digest) {
  Json effects = Json::array(), advice = Json::array();
  for (const PlannedEffect& effect : review.effects)
    effects.push_back(effectJson(review, effect, measurement));
  for (const PlanAdvice& entry : review.advice)
    advice.push_back(
        {{"measure", textOf(entry.measures)}, {"reveals", entry.reveals}, {"separates", entry.separates}});
  Json json = {{"session", session}, {"readings", review.readings}};
  json["sigma_mm"] = review.intersection ? Json(review.intersection->sigma) : Json();
  json["attainable"] = attainableJson(review.attainable);
  json["effects"] = std::move(effects);
  json["advice"] = std::move(advice);
  json["findings"] = findingsJson(findings);
  return answerText(std::move(json), digest);
}

}  // namespace alidade::console
