#include "app/console/fit_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <vector>

#include "app/console/findings_text.h"
#include "app/console/statement_text.h"
#include "app/console/text_layout.h"
#include "app/console/two_faces_text.h"
#include "core/base/number_text.h"
#include "core/base/quantity_text.h"
#include "core/effects/catalogue.h"
#include "core/statement/budget.h"
#include "core/statement/headline.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/effect_name.h"
#include "core/wording/findings.h"
#include "core/wording/position_name.h"
#include "core/wording/suspects.h"

namespace alidade::console {

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string arcName(const ArcFit& arc) {
  return (arc.axisDeg == 0 ? "O1, axis " : "O2, axis ") + positionName(arc.axisDeg, arc.time);
}

std::vector<std::string> arcRow(const ArcFit& arc) {
  return {arcName(arc),
          fixedText(arc.circle.x, 6),
          fixedText(arc.circle.y, 6),
          fixedText(arc.circle.radius, 6),
          std::to_string(arc.residuals.size()),
          std::to_string(arc.degreesOfFreedom),
          fixedText(arc.residualRms, 2),
          arc.degreesOfFreedom > 0 ? fixedText(arc.reducedChiSquare(), 2) : "none"};
}

const std::vector<std::string> arcHeading = {"",     "x (mm)",     "y (mm)",  "radius (mm)",
                                             "rows", "redundancy", "rms (″)", "reduced χ²"};

std::string percent(double share) {
  return shortestText(std::round(share * 1e6) / 1e4) + " %";
}

std::string referenceLine(const Measurement& measurement, double value) {
  if (!measurement.referenceIntersection) return "";
  return "The device was set to " + shortestText(*measurement.referenceIntersection) + " mm; Δd differs by " +
         fixedText(value - *measurement.referenceIntersection, 4) + " mm.\n";
}

std::string coverageText(const Intersection& intersection) {
  constexpr double nearlyNormal = 1000;  // from here on k equals that of known noise to 0.1 %
  const std::string freedom =
      intersection.effectiveDegreesOfFreedom < nearlyNormal
          ? ", " + fixedText(intersection.effectiveDegreesOfFreedom, 1) + " degrees of freedom"
          : "";
  return "(" + percent(intersection.coverage) +
         " coverage, k = " + fixedText(intersection.coverageFactor, 3) + freedom + ")";
}

std::string intersectionText(const Intersection& intersection) {
  return "\nΔd, fit only = " + fixedText(intersection.value, 6) + " mm ± " +
         fixedText(intersection.expanded, 4) + " mm " + coverageText(intersection) +
         "\nCentres apart in the plane: |O1 - O2|/2 = " + fixedText(intersection.inPlane, 6) + " mm ± " +
         fixedText(intersection.inPlaneExpanded, 4) + " mm\n";
}

std::string inCapitals(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// The result and its verdict on one line, its place on the scale of the tolerance, then what to read with
/// them.
std::string headlineText(const Headline& headline, double coverage) {
  constexpr int scaleWidth = 60;
  std::string text = headline.nameAndFigure();
  if (headline.isMeasured) text += " (" + percent(coverage) + " coverage)";
  text += "   " + (headline.decided ? inCapitals(headline.verdict) : headline.verdict);
  if (!headline.tolerance.empty()) text += "   " + headline.tolerance;
  text += "\n";
  if (headline.scale) text += scaleText(*headline.scale, scaleWidth) + "\n";
  for (const Headline::Line& line : headline.lines)
    text += (line.isWarning ? "! " : "  ") + paragraph(line.text + ".", 2);
  return text + "\n";
}

std::string measuredText(const FitAnswer& answer) {
  if (!answer.found() || !answer.diagnosis->measured) return "";
  const IntersectionEstimate& measured = answer.diagnosis->measured->estimate;
  return "\nΔd, measured = " + fixedText(measured.value, 4) + " mm ± " + fixedText(measured.expanded, 4) +
         " mm (" + percent(answer.measurement.coverage) + " coverage)";
}

/// Shown if the gap is more than noise.
std::string gapText(const FitAnswer& answer) {
  if (!answer.diagnosis || !isMoreThanNoise(*answer.diagnosis)) return "";
  return "\n" + paragraph("Gap: " + sentenceOf(*answer.diagnosis) + " `alidade-cli diagnose` says more.");
}

/// "Verdict: accept. Δd = …".
std::string basisText(const FitAnswer& answer, const Headline& headline) {
  const auto decision = decideAcceptance(answer.measurement, answer.fit, answer.found());
  if (!decision) return "Verdict: none. " + headline.sentence;
  return (answer.diagnosis ? "Verdict: " : "Verdict, fit only: ") + verdictName(decision->verdict) + ". " +
         headline.sentence;
}

std::vector<std::string> spreadRow(const std::string& name, const Spread& spread) {
  return {"  " + name, fixedText(spread.mean, 5), fixedText(spread.sigma, 5), fixedText(spread.low, 5),
          fixedText(spread.high, 5)};
}

std::string linearSentence(const MonteCarlo& check) {
  const std::string ends = "the ends of Δd ± U differ from the interval's by " +
                           fixedText(check.lowDifference, 5) + " mm and " +
                           fixedText(check.highDifference, 5) + " mm, the numerical tolerance is " +
                           fixedText(check.tolerance, 5) + " mm.";
  switch (check.linear) {
    case LinearPropagation::Validated:
      return "The linear budget is validated: " + ends;
    case LinearPropagation::Refuted:
      return "The linear budget is not validated: " + ends + " Rely on the interval of the draws.";
    case LinearPropagation::Undecided:
      break;
  }
  return "Too few draws to validate the linear budget (an end is uncertain by " +
         fixedText(check.endpointSigma, 5) + " mm): " + ends;
}

std::string monteCarloText(const MonteCarlo& check) {
  Rows rows = {{"Monte Carlo (mm)", "mean", "u", percent(check.coverage) + " from", "to"}};
  if (check.intersection) rows.push_back(spreadRow("Δd", *check.intersection));
  for (const CentreSpread& centre : check.centres) {
    const std::string at = " at " + std::to_string(centre.axisDeg) + "°";
    rows.push_back(spreadRow("x" + at, centre.x));
    rows.push_back(spreadRow("y" + at, centre.y));
  }
  const std::string failed =
      check.failed > 0 ? std::to_string(check.failed) + " draws gave no result and are left out. " : "";
  return "\n" + alignedColumns(rows) +
         paragraph(std::to_string(check.draws) + " draws, seed " + std::to_string(check.seed) + ". " +
                   failed + (check.intersection ? linearSentence(check) : ""));
}

std::string suspectsText(const std::vector<Suspect>& suspects) {
  if (suspects.empty()) return "";
  std::string text = "\nReadings that look misread\n";
  for (const Suspect& suspect : suspects) {
    text += "  " + paragraph(sentenceOf(suspect), 4);
    for (std::size_t i = 1; i < suspect.proposals.size(); ++i)
      text += "    " + paragraph("Or: " + sentenceOf(suspect.proposals[i]), 6);
  }
  return text;
}

std::string noiseText(const NoiseScale& noise) {
  if (std::isinf(noise.degreesOfFreedom)) return "u rests on the stated noise of the readings alone.\n";
  return "Readings scatter " + fixedText(noise.factor, 2) +
         " times as much as stated (s0); the readings' part of u is scaled by that.\n";
}

std::string effectsText(const std::vector<EffectEstimate>& effects) {
  if (effects.empty()) return "";
  Rows rows = {{"Effects estimated along", "value", "u", "unit"}};
  for (const EffectEstimate& estimate : effects)
    rows.push_back({"  " + causeName(estimate.effect) + ", " + parameterName(estimate.name),
                    fixedText(estimate.value, decimalsFor(estimate.sigma)),
                    fixedText(estimate.sigma, decimalsFor(estimate.sigma)), estimate.unit});
  return "\n" + alignedColumns(rows);
}

std::string correlationText(const SessionFit& fit) {
  std::string text;
  for (std::size_t i = 0; i < fit.arcs.size(); ++i)
    if (fit.arcs[i].time == 1)
      text += (text.empty() ? "" : "; ") + ("at " + positionName(fit.arcs[i].axisDeg)) + " " +
              fixedText(fit.sigmas[i].radiusX, 2) + " and " + fixedText(fit.sigmas[i].radiusY, 2);
  return "Correlation of the radius with x and y: " + text + "\n";
}

std::string arcsText(const SessionFit& fit) {
  Rows rows = {arcHeading};
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    const ArcSigma& sigma = fit.sigmas[i];
    rows.push_back(arcRow(fit.arcs[i]));
    if (fit.arcs[i].time > 1) {  // the shared values are already printed
      for (const std::size_t column : {1, 2, 3})
        rows.back()[column] = "as at " + positionName(fit.arcs[i].axisDeg);
      continue;
    }
    rows.push_back({"  u", fixedText(sigma.x, 4), fixedText(sigma.y, 4), fixedText(sigma.radius, 4)});
  }
  return alignedColumns(rows) + correlationText(fit) + noiseText(fit.noise);
}

std::string arcsText(const PublishedSessionFit& fit) {
  Rows rows = {arcHeading};
  for (const PublishedFit& published : fit.arcs) rows.push_back(arcRow(published.arc));
  return alignedColumns(rows);
}

std::string asPrintedText(const PublishedSessionFit& fit) {
  Rows rows = {{"", "ΔR (mm)", "Δx (mm)", "Δy (mm)", "Δθx (rad)", "Δθy (rad)"}};
  for (const PublishedFit& published : fit.arcs) {
    const AsPrinted& printed = published.asPrinted;
    rows.push_back({arcName(published.arc), fixedText(printed.deltaRadius, 4), fixedText(printed.x, 4),
                    fixedText(printed.y, 4), fixedText(printed.thetaX, 6), fixedText(printed.thetaY, 6)});
  }
  return "\nAs printed: ΔR of the second iteration alone, y in the sense of the vertical circle\n" +
         alignedColumns(rows);
}

std::string intersectionText(const Measurement& measurement, const PublishedSessionFit& fit) {
  if (!fit.intersection) return "";
  std::string text = "\nIntersection Δd = " + fixedText(*fit.intersection, 6) + " mm";
  if (fit.intersectionAsPrinted)
    text += "; in the paper's signs " + fixedText(*fit.intersectionAsPrinted, 4) + " mm";
  return text + "\nCentres apart in the plane: |O1 - O2|/2 = " + fixedText(fit.inPlane, 6) + " mm\n" +
         referenceLine(measurement, *fit.intersection);
}

}  // namespace

std::string fitText(const FitAnswer& answer) {
  const Measurement& measurement = answer.measurement;
  const SessionFit& fit = answer.fit;
  std::string text = heading(answer.session);
  if (fit.intersection) {
    const Headline headline = headlineOf(measurement, fit, answer.found(), answer.dependences);
    text += headlineText(headline, measurement.coverage) + paragraph(basisText(answer, headline)) +
            measuredText(answer) + intersectionText(*fit.intersection) + "\n";
  }
  text += "Rigorous fit: orthogonal least squares on the readings of both circles; x right, y up\n\n" +
          arcsText(fit) + gapText(answer);
  if (answer.diagnosis && answer.diagnosis->measured)
    text += statementText(measuredBudget(*answer.diagnosis, measurement.coverage));
  if (fit.intersection) text += statementText(fitBudget(*fit.intersection));
  if (answer.check) text += monteCarloText(*answer.check);
  text += effectsText(fit.effects);
  if (const auto faces = compareFaces(measurement)) text += twoFacesText(measurement, *faces);
  text += suspectsText(answer.suspects);
  return text + findingsText(inWords(fit.findings, answer.suspects));
}

std::string fitText(const std::string& name, const Measurement& measurement, const PublishedSessionFit& fit) {
  return heading(name) +
         "Published method, two iterations, for comparison with the paper; x right, y up\n\n" +
         arcsText(fit) + asPrintedText(fit) + intersectionText(measurement, fit) +
         "\nThe method states no uncertainty and takes the vertical circle to read y/L, which no theodolite "
         "does:\n"
         "no verdict is drawn from it.\n" +
         findingsText(inWords(fit.findings));
}

}  // namespace alidade::console
