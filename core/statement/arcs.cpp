#include "core/statement/arcs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/adjustment/result/axis_residual_sum.h"
#include "core/base/list_text.h"
#include "core/base/phrase.h"
#include "core/base/quantity_text.h"
#include "core/effects/catalogue.h"
#include "core/wording/effect_name.h"
#include "core/wording/findings.h"
#include "core/wording/position_name.h"
#include "core/wording/size_text.h"

namespace alidade {

namespace {

using Role = Statement::Column::Role;
using Cells = std::vector<std::string>;

constexpr int axes[] = {0, 180};
constexpr int mostDecimals = 4;  // a tenth of a micrometre

std::string arcName(int axisDeg) {
  //: an arc and the position of its axis
  return Phrase::of("%1 at %2", axisDeg == 0 ? "O1" : "O2", positionName(axisDeg));
}

/// Lengths with u in brackets, all with the decimals that the smallest u needs.
struct Lengths {
  int decimals = 0;

  explicit Lengths(const std::vector<ArcSigma>& sigmas) {
    for (const ArcSigma& sigma : sigmas)
      for (const double u : {sigma.x, sigma.y, sigma.radius})
        decimals = std::max(decimals, decimalsFor(u, 0));
    decimals = std::min(decimals, mostDecimals);
  }
  std::string withU(double value, double u) const {
    return displayText(value, decimals) + " (" + displayText(u, decimals) + ")";
  }
};

Cells cellsOf(const SessionFit& fit, std::size_t arc, const Lengths& lengths) {
  const Circle& circle = fit.arcs[arc].circle;
  const ArcSigma& sigma = fit.sigmas[arc];
  const AxisResidualSum sum = residualSumAt(fit, fit.arcs[arc].axisDeg);
  return {arcName(fit.arcs[arc].axisDeg),
          lengths.withU(circle.x, sigma.x),
          lengths.withU(circle.y, sigma.y),
          lengths.withU(circle.radius, sigma.radius),
          std::to_string(sum.sightings),
          displayText(sum.residualRms, 2),
          sum.degreesOfFreedom > 0 ? displayText(sum.reducedChiSquare(), 2) : "—",
          std::to_string(sum.degreesOfFreedom)};
}

}  // namespace

Statement arcTable(const SessionFit& fit) {
  Statement statement{
      .id = "arcs",
      .title = Phrase::of("Arc centres and radii"),
      .columns = {{"arc", "", Role::Name},
                  {"x", Phrase::of("Δx (u), mm"), Role::Figure,
                   Phrase::of("Centre of the arc, right positive, with its standard uncertainty")},
                  {"y", Phrase::of("Δy (u), mm"), Role::Figure,
                   Phrase::of("Centre of the arc, up positive, with its standard uncertainty")},
                  {"radius", Phrase::of("R (u), mm"), Role::Figure,
                   Phrase::of("Fitted radius with its standard uncertainty")},
                  {"sightings", Phrase::of("Sightings")},
                  {"rms", Phrase::of("rms, ″"), Role::Figure,
                   Phrase::of("Root mean square of the residuals of all readings of the arc")},
                  {"reduced_chi_square", Phrase::of("Reduced χ²"), Role::Figure,
                   Phrase::of("About 1 where the readings scatter as stated")},
                  {"redundancy", Phrase::of("Redundancy")}},
      .rows = {}};
  const Lengths lengths(fit.sigmas);
  bool hasRepeats = false;
  for (const int axisDeg : axes) {
    const ArcFit* first = fit.arcAt(axisDeg);
    if (!first) continue;
    statement.rows.push_back({cellsOf(fit, static_cast<std::size_t>(first - fit.arcs.data()), lengths)});
    const auto isHere = [&](const ArcFit& arc) { return arc.axisDeg == axisDeg; };
    if (std::ranges::count_if(fit.arcs, isHere) < 2) continue;
    hasRepeats = true;
    for (const ArcFit& arc : fit.arcs)
      if (isHere(arc))
        statement.rows.push_back(
            {.cells = {positionName(axisDeg, arc.repeat), "", "", "", std::to_string(arc.residuals.size()),
                       displayText(arc.residualRms, 2), "", ""},
             .isPart = true});
  }
  if (fit.intersection)
    statement.sentences = {
        Phrase::of("Half the distance of the centres: |O1 − O2|/2 = %1.",
                   sizeWithExpanded(fit.intersection->inPlane, fit.intersection->inPlaneExpanded, "mm"))};
  statement.note = Phrase::of("x right, y up; u: standard, scaled by s0 = %1; rms: of all residuals.",
                              displayText(fit.noise.factor, 2));
  if (hasRepeats)
    statement.note = inTurn(statement.note,
                            Phrase::of("Positions at the same axis angle share one centre and one radius."));
  return statement;
}

Statement publishedTable(const PublishedSessionFit& fit) {
  Statement statement{.id = "published",
                      .title = Phrase::of("Published method, as printed"),
                      .columns = {{"arc", "", Role::Name},
                                  {"x", "Δx (mm)"},
                                  {"y", "Δy (mm)"},
                                  {"radius", "ΔR (mm)"},
                                  {"theta_x", "Δθx (rad)"},
                                  {"theta_y", "Δθy (rad)"}},
                      .rows = {}};
  for (const int axisDeg : axes) {
    AsPrinted sum{};
    double count = 0;
    for (const PublishedFit& arc : fit.arcs) {
      if (arc.arc.axisDeg != axisDeg) continue;
      ++count;
      for (double AsPrinted::*figure :
           {&AsPrinted::x, &AsPrinted::y, &AsPrinted::deltaRadius, &AsPrinted::thetaX, &AsPrinted::thetaY})
        sum.*figure += arc.asPrinted.*figure;
    }
    if (count == 0) continue;
    const auto mean = [&](double whole, int decimals) { return displayText(whole / count, decimals); };
    statement.rows.push_back({{arcName(axisDeg), mean(sum.x, 4), mean(sum.y, 4), mean(sum.deltaRadius, 4),
                               mean(sum.thetaX, 6), mean(sum.thetaY, 6)}});
  }
  if (fit.intersection && fit.intersectionAsPrinted)
    statement.sentences = {Phrase::of("Δd as printed = %1 mm; with y up %2 mm; |O1 − O2|/2 = %3 mm.",
                                      displayText(*fit.intersectionAsPrinted, 4),
                                      displayText(*fit.intersection, 4), displayText(fit.inPlane, 4))};
  statement.note = Phrase::of(
      "As printed: y points down for zenith angles, ΔR is the last increment, θ are not tilts. The method "
      "states no uncertainty and assumes tan e = y/L, but no theodolite reads this angle e; do not accept a "
      "guideway by this method.");
  return statement;
}

Statement effectTable(const std::vector<EffectEstimate>& effects) {
  Statement statement{.id = "model_effects",
                      .title = Phrase::of("Model effects"),
                      .columns = {{"effect", Phrase::of("Estimated along with the arcs"), Role::Name},
                                  {"value", Phrase::of("value")},
                                  {"u", "u"}},
                      .rows = {}};
  for (const EffectEstimate& estimate : effects) {
    const int decimals = decimalsFor(estimate.sigma);
    const std::string effect = effectName(estimate.effect), unit = signOf(estimate.unit);
    statement.rows.push_back(
        {{estimate.effect.ends_with(estimate.name) ? effect : listed({effect, parameterName(estimate.name)}),
          displayText(estimate.value, decimals) + unit, displayText(estimate.sigma, decimals) + unit}});
  }
  return statement;
}

}  // namespace alidade
