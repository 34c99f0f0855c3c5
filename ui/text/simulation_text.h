#pragma once

#include <QString>

#include "core/adjustment/monte_carlo/monte_carlo.h"

namespace alidade::ui {

/// The largest number the user can request.
inline constexpr int mostDraws = 5000000;

/// A word or a few: whether propagated and simulated uncertainty agree: "Agrees."
QString agreementWord(const MonteCarlo& check);

/// The difference of the interval ends, the tolerance, and the consequence.
QString agreementSentence(const MonteCarlo& check);

/// The whole check in a paragraph for paper; needs an intersection.
QString simulationParagraph(const MonteCarlo& check);

}  // namespace alidade::ui
