#include "ui/text/simulation_text.h"

#include <QCoreApplication>
#include <cmath>

#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("Simulation", text);
}

/// An end is uncertain as one over the square root of the draws, and is to be known three times better than
/// the tolerance; to one digit.
qint64 drawsToTell(const MonteCarlo& check) {
  const double ratio = 3 * check.endpointSigma / check.tolerance;
  const double draws = static_cast<double>(check.draws) * ratio * ratio;
  const double digit = std::pow(10, std::floor(std::log10(draws)));
  return static_cast<qint64>(std::ceil(draws / digit) * digit);
}

}  // namespace

QString agreementWord(LinearPropagation linear) {
  switch (linear) {
    case LinearPropagation::Validated:
      return translated("Agrees.");
    case LinearPropagation::Refuted:
      return translated("Does not agree.");
    case LinearPropagation::Undecided:
      break;
  }
  return translated("No disagreement, but too few draws to be sure.");
}

QString agreementSentence(const MonteCarlo& check) {
  const int decimals = decimalsFor(check.tolerance);
  QString text =
      translated("The ends of Δd ± U differ from those simulated by %1 and %2; the tolerance is %3.")
          .arg(numberText(check.lowDifference, decimals), lengthText(check.highDifference, decimals),
               lengthText(check.tolerance, decimals));
  if (check.linear == LinearPropagation::Refuted)
    text += translated(" Rely on the simulated interval.");
  else if (check.linear == LinearPropagation::Undecided)
    text += translated(" By chance alone an end is uncertain by %1: about %2 draws would tell.")
                .arg(lengthText(check.endpointSigma, decimals))
                .arg(drawsToTell(check));
  if (check.failed > 0) text += translated(" %1 draws gave no result and are left out.").arg(check.failed);
  return text;
}

QString simulationParagraph(const MonteCarlo& check) {
  const Spread& spread = *check.intersection;
  return translated("Checked by simulation (JCGM 101, %1 draws): Δd = %2, u = %3, %4 % from %5 to %6. %7 %8")
      .arg(check.draws)
      .arg(lengthText(spread.mean, 4), lengthText(spread.sigma, 4), plainNumberText(100 * check.coverage),
           numberText(spread.low, 4), lengthText(spread.high, 4), agreementWord(check.linear),
           agreementSentence(check));
}

}  // namespace alidade::ui
