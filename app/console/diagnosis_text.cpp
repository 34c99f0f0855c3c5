#include "app/console/diagnosis_text.h"

#include <algorithm>
#include <cmath>

#include "app/console/findings_text.h"
#include "app/console/forms_text.h"
#include "app/console/text_layout.h"
#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/quantity_text.h"
#include "core/base/visible_text.h"
#include "core/effects/cause_ids.h"
#include "core/wording/attainable.h"
#include "core/wording/beyond.h"
#include "core/wording/cause_prior.h"
#include "core/wording/closures.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/known_checks.h"
#include "core/wording/measure.h"
#include "core/wording/position_name.h"
#include "core/wording/verdict.h"

namespace alidade::console {

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string gapText(const Diagnosis& diagnosis) {
  const auto row = [](const std::string& name, const GapSize& size,
                      const std::optional<IntersectionEstimate>& estimate) {
    return std::vector<std::string>{
        name, fixedText(size.rms, 2),
        std::isnan(size.reducedChiSquare) ? "none" : fixedText(size.reducedChiSquare, 2),
        estimate ? fixedText(estimate->value, 4) : "none",
        estimate ? fixedText(estimate->expanded, 4) : "none"};
  };
  Rows rows{{"", "rms (″)", "reduced χ²", "Δd (mm)", "U (mm)"},
            row("as modelled", diagnosis.gap, diagnosis.before)};
  for (const GapStep& step : diagnosis.steps)
    rows.push_back(row(step.effect == grossErrorId ? "without the misread values"
                       : step.effect == knownId    ? "with what is known"
                       : step.effect == formId     ? "with the form"
                                                   : "with " + step.effect,
                       step.size, step.intersection));
  if (const std::string beyond = textOf(beyondTheFit(diagnosis)); !beyond.empty())
    rows.push_back(row(beyond, diagnosis.after, diagnosis.afterwards));
  return "\n" + alignedColumns(rows);
}

std::string readingText(const ReadingDeviation& reading) {
  return std::string(nameOf(reading.kind)) + " reading of point " + std::to_string(reading.point) +
         ", round " + std::to_string(reading.round) + ", face " + std::to_string(reading.face) + " at " +
         positionName(reading.axisDeg, reading.time) + ", off by " + fixedText(reading.size, 1) + "″";
}

/// A value with two digits of its σ.
std::string sizeText(double value, double sigma) {
  return fixedText(value, decimalsFor(sigma, 0));
}

/// The assumptions of the probability.
std::string givenText(const Cause& cause) {
  if (cause.isStale) return ", that what is known of it holds no longer";
  const std::string plausible = plausibleSizeText(cause.effect);
  return ", given the catalogue" +
         (plausible.empty() ? "" : " and a plausible size of " + plausible + " (1σ)");
}

std::string causeText(const Cause& cause) {
  std::string text = "\nCause: " + cause.effect + ", probability " + shortProbabilityText(cause.probability) +
                     givenText(cause) + "\n";
  for (const CauseParameter& parameter : cause.parameters)
    text += "  " + parameter.name + " " + sizeText(parameter.value, parameter.sigma) +
            (parameter.unit.size() > 1 ? " " + parameter.unit : "") +
            (parameter.sigma > 0 ? " (u " + sizeText(parameter.sigma, parameter.sigma) + ")" : "") + "\n";
  for (const ReadingDeviation& reading : cause.readings) text += "  " + readingText(reading) + "\n";
  if (!cause.indistinguishableFrom.empty())
    text +=
        paragraph("  These readings cannot tell it from: " + listed(cause.indistinguishableFrom) + ".", 2);
  return text;
}

std::string knownText(const Diagnosis& diagnosis) {
  if (diagnosis.known.empty()) return "";
  std::string text = "\nKnown beforehand\n";
  for (const KnownCheck& check : diagnosis.known)
    text += paragraph(
        "  " + textOf(check) + (check.from.empty() ? "" : " (" + visibleText(check.from) + ")") + ".", 4);
  return text;
}

/// "face 1", "180°", "30…60°", "horizontal".
std::string partText(const GapShare& share) {
  if (share.by == "position") return share.of + "°";
  if (share.by == "face" || share.by == "round") return share.by + " " + share.of;
  return share.of;
}

/// A line for each division of the readings into two or more parts, in order; parts below one percent are
/// left out.
std::string whereText(const Diagnosis& diagnosis) {
  std::string text = "\nWhere it lies\n";
  for (auto first = diagnosis.where.begin(); first != diagnosis.where.end();) {
    const auto end = std::find_if(first, diagnosis.where.end(),
                                  [&](const GapShare& share) { return share.by != first->by; });
    std::vector<std::string> parts;
    for (auto share = first; share != end; ++share)
      if (share->share >= 0.01)
        parts.push_back(partText(*share) + ": " + fixedText(100 * share->share, 0) + " %");
    if (end - first > 1) text += paragraph("  by " + first->by + " – " + listed(parts), 4);
    first = end;
  }
  return text;
}

std::string closuresText(const Diagnosis& diagnosis) {
  if (diagnosis.closures.empty()) return "";
  std::string text = "\nClosures: what must agree\n";
  for (const ClosureStep& step : diagnosis.closures) {
    text += "  " + textOf(step.before);
    if (step.after && !diagnosis.causes.empty()) text += "; with the causes " + textOf(*step.after);
    text += "\n";
  }
  const std::string open = misclosureSentence(diagnosis);
  return open.empty() ? text : text + paragraph(open);
}

/// Numbers in two directions have no sign.
std::string whatItWouldTakeText(const Diagnosis& diagnosis) {
  if (diagnosis.whatItWouldTake.empty()) return "";
  Rows rows{{"  effect", "size", "plausible sizes", "leaves (σ)"}};
  for (const Required& required : diagnosis.whatItWouldTake)
    rows.push_back({"  " + required.effect,
                    sizeText(required.size, std::abs(required.size)) +
                        (required.unit.size() > 1 ? " " + required.unit : ""),
                    fixedText(required.plausibleSizes, 1), fixedText(required.visibleSigma, 1)});
  return "\nWhat it would take to explain Δd − reference\n" + alignedColumns(rows);
}

std::string adviceText(const Diagnosis& diagnosis) {
  if (diagnosis.advice.empty()) return "";
  std::string text = "\nWhat to measure next\n";
  for (const Advice& advice : diagnosis.advice)
    text += paragraph("  " + howTo(advice.measures) +
                          (advice.ofUndetectable ? ": would show " : ": tells apart every two of ") +
                          listed(advice.separates) + ", by " + fixedText(advice.bySigma, 1) + " σ or more" +
                          (advice.oneLeft > 0 ? "; one answer is left with a probability of " +
                                                    shortProbabilityText(advice.oneLeft)
                                              : std::string()),
                      4);
  return text;
}

std::string attainableText(const Diagnosis& diagnosis) {
  const std::string sentence = attainableSentence(diagnosis.attainable);
  return sentence.empty() ? sentence : "\nWhat U could be\n" + paragraph("  " + sentence, 2);
}

std::string undetectableText(const Diagnosis& diagnosis) {
  if (diagnosis.undetectable.empty()) return "";
  Rows rows{{"  effect", "moves Δd by (mm)", "leaves (σ)"}};
  for (const UndetectableEffect& effect : diagnosis.undetectable)
    rows.push_back({"  " + effect.effect, fixedText(effect.influence, 4), fixedText(effect.visibleSigma, 1)});
  return "\nUnseen: what a plausible size of these would do without leaving a clear trace\n" +
         alignedColumns(rows);
}

}  // namespace

std::string diagnosisText(const std::string& session, const Diagnosis& diagnosis,
                          const std::vector<Finding>& findings) {
  std::string text = heading(session) + "\nVerdict: " + std::string(nameOf(diagnosis.verdict)) + "\n" +
                     paragraph(sentenceOf(diagnosis)) + gapText(diagnosis);
  for (const Cause& cause : diagnosis.causes) text += causeText(cause);
  text += formsText(diagnosis.forms) + knownText(diagnosis);
  if (diagnosis.verdict != DiagnosisVerdict::WithinNoise) text += whereText(diagnosis);
  return text + closuresText(diagnosis) + whatItWouldTakeText(diagnosis) + adviceText(diagnosis) +
         attainableText(diagnosis) + undetectableText(diagnosis) + findingsText(findings);
}

}  // namespace alidade::console
