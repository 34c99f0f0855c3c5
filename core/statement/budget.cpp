#include "core/statement/budget.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/wording/budget.h"
#include "core/wording/closures.h"
#include "core/wording/effect_name.h"
#include "core/wording/findings.h"

namespace alidade {

namespace {

/// The σ that the pointing zeros contribute with.
std::string zeroSentence(const SessionFit& fit) {
  if (fit.joint.zerosAreReadings && fit.noise.factor > fit.joint.zeroScatter)
    return Phrase::of("So are those of the pointing zeros; the distance contributes with its stated σ.");
  if (fit.joint.zeroScatter > 1)
    return Phrase::of(
        "Those of the pointing zeros are %1 times their stated σ, because the sightings of the "
        "zeros scatter so much; the distance contributes with its stated σ.",
        displayText(fit.joint.zeroScatter, 2));
  return Phrase::of("Pointing zeros and distance contribute with their stated σ.");
}

using Role = Statement::Column::Role;
using Cells = std::vector<std::string>;

std::string nameOf(const UncertaintyShare& share) {
  return share.effect.empty() ? textOf(share) : effectName(share.effect);
}

/// "0.0071": the change of Δd, mm, per unit of an effect's numbers; empty if their 1σ or units differ.
std::string sensitivityText(const UncertaintyShare& share) {
  if (share.sizes.empty()) return "";
  const PlausibleSize& first = share.sizes.front();
  const bool isOfOneSize = std::ranges::all_of(share.sizes, [&](const PlausibleSize& size) {
    return size.sigma == first.sigma && size.unit == first.unit;
  });
  if (!isOfOneSize || !(first.sigma > 0)) return "";
  const double rate = share.sigma / first.sigma;
  return displayText(rate, decimalsFor(rate));
}

/// "B", or "A, 32" with its degrees of freedom.
std::string typeWithDegrees(const UncertaintyShare& share) {
  const std::string type = textOf(share.type);
  return std::isfinite(share.degreesOfFreedom) ? type + ", " + degreesOfFreedomText(share.degreesOfFreedom)
                                               : type;
}

/// Makes the rows of the budget of Δd, measured.
struct ShareRows {
  double sigma = 0;  ///< u of Δd, measured, mm
  int decimals = decimalsFor(sigma) + 1;

  Cells cells(std::string name, double part, Cells size = {"", "", "", ""}) const {
    return {std::move(name),    std::move(size[0]),          std::move(size[1]),        std::move(size[2]),
            std::move(size[3]), displayText(part, decimals), varianceShare(part, sigma)};
  }
  Cells cells(const UncertaintyShare& share) const {
    return cells(nameOf(share), share.sigma,
                 {sizesWithSign(share), typeWithDegrees(share),
                  share.reference.empty() ? textOf(share.from) : visibleText(share.reference),
                  sensitivityText(share)});
  }
};

std::vector<Statement::Row> sharesOf(const MeasuredIntersection& measured) {
  const ShareRows table{measured.estimate.sigma};
  const double variance = table.sigma * table.sigma;
  std::vector<Statement::Row> rows;
  std::vector<const UncertaintyShare*> others;
  for (const UncertaintyShare& share : measured.budget) {
    if (share.sigma * share.sigma < leastShare * variance)
      others.push_back(&share);
    else
      rows.push_back({table.cells(share)});
  }
  if (others.size() == 1) rows.push_back({table.cells(*others.front())});
  if (others.size() < 2) return rows;
  double together = 0;
  for (const UncertaintyShare* share : others) together = std::hypot(together, share->sigma);
  rows.push_back({table.cells(Phrase::of("%1 others", others.size()), together)});
  return rows;
}

}  // namespace

Statement measuredBudget(const Diagnosis& diagnosis, double coverage) {
  const MeasuredIntersection& measured = *diagnosis.measured;
  const IntersectionEstimate& found = measured.estimate;
  Statement statement{.id = "budget_measured",
                      .title = Phrase::of("Standard uncertainty of Δd, measured"),
                      .columns = {{"source", Phrase::of("Source"), Role::Name},
                                  {"size", "1σ"},
                                  {"type", Phrase::of("type"), Role::Word},
                                  {"from", Phrase::of("size from"), Role::Remark},
                                  {"sensitivity", "c"},
                                  {"u", "u (mm)"},
                                  {"share", Phrase::of("share")}},
                      .rows = sharesOf(measured)};
  const ShareRows table{found.sigma};
  statement.rows.push_back({table.cells(Phrase::of("combined, u"), found.sigma,
                                        {"", "", "ν = " + degreesOfFreedomText(found.degreesOfFreedom), ""}),
                            true});
  statement.rows.push_back(
      {{Phrase::of("expanded, U"), "", "", coverageWithFactor(found.expanded / found.sigma, coverage), "",
        displayText(found.expanded, table.decimals), ""},
       true});
  statement.sentences = {
      Phrase::of("Δd, measured, includes every catalogued effect, limited by these readings or by its "
                 "plausible size."),
      acrossSentence(measured)};
  statement.note = Phrase::of(
      "1σ: plausible size of each effect; c: sensitivity, the change of Δd in mm per unit of the effect in "
      "these readings; ν: degrees of freedom; share: of the variance. A: from the scatter of these readings; "
      "B: from other knowledge.");
  return statement;
}

Statement fitBudget(const SessionFit& fit) {
  const Intersection& intersection = *fit.intersection;
  const double sigma = intersection.sigma;
  const int decimals = decimalsFor(sigma) + 1;
  Statement statement{.id = "budget_fit",
                      .title = Phrase::of("Standard uncertainty of Δd, fit only"),
                      .columns = {{"source", Phrase::of("Source"), Role::Name},
                                  {"remark", "", Role::Remark},
                                  {"degrees", "ν"},
                                  {"u", "u (mm)"},
                                  {"share", Phrase::of("share")}},
                      .rows = {}};
  const auto cells = [&](const std::string& name, double part, double degrees) {
    return Cells{name, "", degreesOfFreedomText(degrees), displayText(part, decimals),
                 varianceShare(part, sigma)};
  };
  for (const BudgetEntry& entry : intersection.budget)
    statement.rows.push_back(
        {cells(textOf(entry.source), entry.sigma,
               entry.scaled > 0 ? fit.noise.degreesOfFreedom : std::numeric_limits<double>::infinity())});
  statement.rows.push_back(
      {cells(Phrase::of("combined, u"), sigma, intersection.effectiveDegreesOfFreedom), true});
  statement.rows.push_back(
      {{Phrase::of("expanded, U"), coverageWithFactor(intersection.coverageFactor, intersection.coverage), "",
        displayText(intersection.expanded, decimals), ""},
       true});
  return statement;
}

Statement centreBudget(const SessionFit& fit) {
  Statement statement{.id = "budget_centres",
                      .title = Phrase::of("Standard uncertainty of the centres (mm)"),
                      .columns = {{"source", Phrase::of("Source"), Role::Name}},
                      .rows = {}};
  const auto addColumn = [&](const std::string& title, const std::vector<BudgetEntry>& budget,
                             double withRadius) {
    statement.columns.push_back({title, title});
    statement.rows.resize(budget.size() + 2);
    for (std::size_t i = 0; i < budget.size(); ++i) {
      Cells& cells = statement.rows[i].cells;
      if (cells.empty()) cells.push_back(textOf(budget[i].source));
      cells.push_back(displayText(budget[i].sigma, 4));
    }
    statement.rows[budget.size()].cells.push_back(displayText(combined(budget), 4));
    statement.rows.back().cells.push_back(displayText(withRadius, 2));
  };
  for (std::size_t arc = 0; arc < fit.budgets.size(); ++arc) {
    const int axisDeg = fit.arcs[arc].axisDeg;
    if (&fit.arcs[arc] != fit.arcAt(axisDeg)) continue;  // a repeat has the same centre
    const std::string axis = " " + std::to_string(axisDeg) + "°";
    addColumn("Δx" + axis, fit.budgets[arc].x, fit.sigmas[arc].radiusX);
    addColumn("Δy" + axis, fit.budgets[arc].y, fit.sigmas[arc].radiusY);
  }
  if (statement.rows.empty()) return statement;
  Statement::Row& whole = statement.rows[statement.rows.size() - 2];
  whole.cells.insert(whole.cells.begin(), Phrase::of("combined, u"));
  whole.isTotal = true;
  Cells& last = statement.rows.back().cells;
  last.insert(last.begin(), Phrase::of("correlation with R"));
  statement.sentences = {
      std::isinf(fit.noise.degreesOfFreedom)
          ? Phrase::of("Contributions of the readings are based on the stated noise.")
          : Phrase::of("Contributions of the readings are scaled by their scatter, %1 times "
                       "the stated noise.",
                       displayText(fit.noise.factor, 2)),
      zeroSentence(fit)};
  statement.note = Phrase::of(
      "Correlation with R, −1 to 1: how strongly an error of the radius shifts the centre; on half an arc, R "
      "determines the height of the centre.");
  return statement;
}

std::string coverageSentences(const SessionFit& fit, const Diagnosis* diagnosis, const std::string& fitOnly) {
  const Intersection& fitted = *fit.intersection;
  const auto u = [](double sigma) { return displayText(sigma, decimalsFor(sigma)) + " mm"; };
  std::string sentences = Phrase::of("U: coverage %1.", coverageText(fitted.coverage));
  if (diagnosis && diagnosis->measured) {
    const IntersectionEstimate& found = diagnosis->measured->estimate;
    sentences = inTurn(sentences, Phrase::of("Δd, measured: u = %1, ν = %2.", u(found.sigma),
                                             degreesOfFreedomText(found.degreesOfFreedom)));
  }
  return inTurn(sentences,
                Phrase::of("%1, k = %2, u = %3, ν = %4.", fitOnly, displayText(fitted.coverageFactor, 2),
                           u(fitted.sigma), degreesOfFreedomText(fitted.effectiveDegreesOfFreedom)));
}

std::string varianceShare(double part, double whole) {
  return whole > 0 ? displayText(100 * part * part / (whole * whole), 1) + " %" : "—";
}

std::string coverageWithFactor(double factor, double coverage) {
  return Phrase::of("k = %1, %2 coverage", displayText(factor, 2), coverageText(coverage));
}

std::string coverageText(double share) {
  return displayShortest(std::round(share * 1e6) / 1e4) + " %";
}

std::string degreesOfFreedomText(double degrees) {
  constexpr double beyondCounting = 1e4, fewDegrees = 10;
  if (!std::isfinite(degrees)) return "∞";
  return degrees > beyondCounting ? Phrase::of("many") : displayText(degrees, degrees < fewDegrees ? 1 : 0);
}

}  // namespace alidade
