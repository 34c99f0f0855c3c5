#pragma once

#include <QString>

#include "core/adjustment/monte_carlo/monte_carlo.h"

namespace alidade::ui {

/// As many as can be asked for.
inline constexpr int mostDraws = 5000000;

/// Whether the propagated uncertainty and the simulated one agree, in a word or a few: "Agrees."
QString agreementWord(const MonteCarlo& check);

/// By how much the ends of the intervals differ, against what tolerance, and what follows from it.
QString agreementSentence(const MonteCarlo& check);

/// The whole check in a paragraph for paper; needs an intersection.
QString simulationParagraph(const MonteCarlo& check);

}  // namespace alidade::ui
