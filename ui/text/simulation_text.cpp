#include "ui/text/simulation_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

struct SimulationText {
  Q_DECLARE_TR_FUNCTIONS(SimulationText)
};

double worstDifference(const MonteCarlo& check) {
  return std::max(check.lowDifference, check.highDifference);
}

/// Draws needed to decide, to one digit. An end has an uncertainty proportional to one over the square root
/// of the draws; three times that must fit within the tolerance. If an end differs by more, it must also fit
/// within the excess. Empty if more than `mostDraws`.
std::optional<qint64> drawsToTell(const MonteCarlo& check) {
  const double excess = worstDifference(check) - check.tolerance;
  const double room = excess > 0 ? std::min(check.tolerance, excess) : check.tolerance;
  const double ratio = 3 * check.endpointSigma / room;
  const double draws = static_cast<double>(check.draws) * ratio * ratio;
  if (!(draws <= mostDraws)) return std::nullopt;
  const double digit = std::pow(10, std::floor(std::log10(draws)));
  return static_cast<qint64>(std::ceil(draws / digit) * digit);
}

QString chanceSentence(const MonteCarlo& check, int decimals) {
  const QString text = SimulationText::tr(" By chance alone an end is uncertain by %1")
                           .arg(lengthText(check.endpointSigma, decimals));
  const std::optional<qint64> draws = drawsToTell(check);
  return text + (draws
                     ? SimulationText::tr(": about %1 draws would tell.").arg(*draws)
                     : SimulationText::tr("; it would take more draws than can be asked for here to tell."));
}

}  // namespace

QString agreementWord(const MonteCarlo& check) {
  switch (check.linear) {
    case LinearPropagation::Validated:
      return SimulationText::tr("Agrees.");
    case LinearPropagation::Refuted:
      return SimulationText::tr("Does not agree.");
    case LinearPropagation::Undecided:
      break;
  }
  return worstDifference(check) > check.tolerance
             ? SimulationText::tr("Too few draws to tell.")
             : SimulationText::tr("No disagreement, but too few draws to be sure.");
}

QString agreementSentence(const MonteCarlo& check) {
  const int decimals = decimalsFor(check.tolerance);
  QString text =
      SimulationText::tr("The ends of Δd ± U differ from those simulated by %1 and %2; the tolerance is %3.")
          .arg(numberText(check.lowDifference, decimals), lengthText(check.highDifference, decimals),
               lengthText(check.tolerance, decimals));
  if (check.linear == LinearPropagation::Refuted)
    text += SimulationText::tr(" Rely on the simulated interval.");
  else if (check.linear == LinearPropagation::Undecided)
    text += chanceSentence(check, decimals);
  if (check.failed > 0)
    text += SimulationText::tr(" Draws without a result, left out: %1.").arg(check.failed);
  return text;
}

QString simulationParagraph(const MonteCarlo& check) {
  const Spread& spread = *check.intersection;
  return SimulationText::tr(
             "Monte Carlo (JCGM 101, %1 draws) of Δd, fit only: Δd = %2, u = %3, %4 % from %5 to %6. %7 %8")
      .arg(check.draws)
      .arg(lengthText(spread.mean, 4), lengthText(spread.sigma, 4), plainNumberText(100 * check.coverage),
           numberText(spread.low, 4), lengthText(spread.high, 4), agreementWord(check),
           agreementSentence(check));
}

}  // namespace alidade::ui
