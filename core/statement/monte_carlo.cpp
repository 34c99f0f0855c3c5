#include "core/statement/budget.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/wording/findings.h"

namespace alidade {

namespace {

constexpr int drawnDecimals = 4;

Statement::Row row(std::string name, const Spread& spread) {
  return {{std::move(name), displayText(spread.mean, drawnDecimals), displayText(spread.sigma, drawnDecimals),
           displayText(spread.low, drawnDecimals), displayText(spread.high, drawnDecimals)}};
}

std::string lengthText(double millimetres, int places) {
  return displayText(millimetres, places) + " mm";
}

double worstDifference(const MonteCarlo& check) {
  return std::max(check.lowDifference, check.highDifference);
}

/// Draws needed to decide, rounded up to one digit. The uncertainty of an end is proportional to one over the
/// square root of the draws. Three times this uncertainty must fit within the tolerance and, if an end
/// differs by more than the tolerance, also within the excess. Empty if more than `mostDrawsLeftOpen`.
std::optional<std::size_t> drawsToDecide(const MonteCarlo& check) {
  const double excess = worstDifference(check) - check.tolerance;
  const double room = excess > 0 ? std::min(check.tolerance, excess) : check.tolerance;
  const double ratio = 3 * check.endpointSigma / room;
  const double draws = static_cast<double>(check.draws) * ratio * ratio;
  if (!(draws <= mostDrawsLeftOpen)) return std::nullopt;
  const double digit = std::pow(10, std::floor(std::log10(draws)));
  return static_cast<std::size_t>(std::ceil(draws / digit) * digit);
}

std::string chanceSentence(const MonteCarlo& check, int places) {
  const std::string end = lengthText(check.endpointSigma, places);
  const std::optional<std::size_t> draws = drawsToDecide(check);
  return draws ? Phrase::of(
                     "With these draws, an end of the interval is uncertain by %1: a decision needs about %2 "
                     "draws.",
                     end, *draws)
               : Phrase::of(
                     "With these draws, an end of the interval is uncertain by %1: a decision needs more "
                     "draws than can be set here.",
                     end);
}

}  // namespace

Statement monteCarloCheck(const MonteCarlo& check, const Intersection* linear) {
  Statement statement{.id = "monte_carlo",
                      .title = Phrase::of("Monte Carlo check of Δd, fit only"),
                      .columns = {{"quantity", "", Statement::Column::Role::Name},
                                  {"mean", Phrase::of("mean (mm)")},
                                  {"u", "u (mm)"},
                                  {"low", Phrase::of("%1 from", coverageText(check.coverage))},
                                  {"high", Phrase::of("to (mm)")}},
                      .rows = {}};
  if (linear)
    statement.rows.push_back(row(
        Phrase::of("Δd, propagated"),
        {linear->value, linear->sigma, linear->value - linear->expanded, linear->value + linear->expanded}));
  if (check.intersection) statement.rows.push_back(row(Phrase::of("Δd, simulated"), *check.intersection));
  for (const CentreSpread& centre : check.centres) {
    const std::string axis = " " + std::to_string(centre.axisDeg) + "°";
    statement.rows.push_back(row("Δx" + axis, centre.x));
    statement.rows.push_back(row("Δy" + axis, centre.y));
  }
  if (check.intersection)
    statement.sentences.push_back(inTurn(agreementWord(check), agreementSentence(check)));
  statement.note = Phrase::of("JCGM 101: %1 draws of all readings, seed %2; the centres are those simulated.",
                              check.draws, check.seed);
  return statement;
}

std::string agreementWord(const MonteCarlo& check) {
  switch (check.linear) {
    case LinearPropagation::Validated:
      return Phrase::of("Agrees.");
    case LinearPropagation::Refuted:
      return Phrase::of("Does not agree.");
    case LinearPropagation::Undecided:
      break;
  }
  return worstDifference(check) > check.tolerance
             ? Phrase::of("Too few draws to decide.")
             : Phrase::of("No disagreement, but too few draws to be sure.");
}

std::string agreementSentence(const MonteCarlo& check) {
  const int places = decimalsFor(check.tolerance);
  std::string text = Phrase::of(
      "The ends of Δd ± U differ by %1 and %2 from the simulated ends; the numerical tolerance is %3.",
      displayText(check.lowDifference, places), lengthText(check.highDifference, places),
      lengthText(check.tolerance, places));
  if (check.linear == LinearPropagation::Refuted)
    text = inTurn(text, Phrase::of("Rely on the simulated interval."));
  else if (check.linear == LinearPropagation::Undecided)
    text = inTurn(text, chanceSentence(check, places));
  if (check.failed > 0)
    text = inTurn(text, Phrase::of("Draws without a result (excluded): %1.", check.failed));
  return text;
}

}  // namespace alidade
