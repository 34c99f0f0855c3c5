#include "app/console/fit_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/console/text_layout.h"
#include "core/base/number_text.h"
#include "core/statement/arcs.h"
#include "core/statement/budget.h"
#include "core/statement/headline.h"
#include "core/statement/reliability.h"
#include "core/statement/two_faces.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/findings.h"

namespace alidade::console {

namespace {

std::string percent(double share) {
  return shortestText(std::round(share * 1e6) / 1e4) + " %";
}

std::string inCapitals(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// The result and its verdict on one line, the scale of the tolerance, then the headline's further lines.
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

/// The sentence on the gap; empty without a diagnosis, or if noise explains the gap.
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

}  // namespace

std::string fitText(const FitAnswer& answer) {
  const Measurement& measurement = answer.measurement;
  const SessionFit& fit = answer.fit;
  std::string text = heading(answer.session);
  if (fit.intersection) {
    const Headline headline = headlineOf(measurement, fit, answer.found(), answer.dependences);
    text += headlineText(headline, measurement.coverage) + paragraph(basisText(answer, headline)) +
            paragraph(coverageSentences(fit, answer.found(), headline.fitOnly));
  }
  text += statementText(arcTable(fit)) + gapText(answer);
  if (answer.diagnosis && answer.diagnosis->measured)
    text += statementText(measuredBudget(*answer.diagnosis, measurement.coverage));
  if (fit.intersection) text += statementText(fitBudget(fit));
  text += statementText(centreBudget(fit));
  if (answer.check)
    text += statementText(monteCarloCheck(*answer.check, fit.intersection ? &*fit.intersection : nullptr));
  text += statementText(reliabilityTable(measurement, fit)) + statementText(effectTable(fit.effects));
  if (const auto faces = compareFaces(measurement))
    text += statementText(faceDifferences(measurement, *faces)) + statementText(instrumentErrors(*faces));
  text += statementText(suspectTable(answer.suspects));
  return text + findingsText(inWords(fit.findings, answer.suspects));
}

std::string fitText(const std::string& name, const PublishedSessionFit& fit) {
  return heading(name) + statementText(publishedTable(fit)) + findingsText(inWords(fit.findings));
}

}  // namespace alidade::console
