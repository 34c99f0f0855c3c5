#include "ui/text/simulation_text.h"

#include <QCoreApplication>

#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("Simulation", text);
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
  return translated("Too few draws to tell.");
}

QString agreementSentence(const MonteCarlo& check) {
  QString text =
      translated("The ends of Δd ± U differ from those simulated by %1 and %2; the tolerance is %3.")
          .arg(numberText(check.lowDifference, 4), lengthText(check.highDifference, 4),
               lengthText(check.tolerance, decimalsFor(check.tolerance)));
  if (check.linear == LinearPropagation::Refuted)
    text += translated(" Rely on the simulated interval.");
  else if (check.linear == LinearPropagation::Undecided)
    text +=
        translated(" With so many draws an end is uncertain by %1.").arg(lengthText(check.endpointSigma, 4));
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
