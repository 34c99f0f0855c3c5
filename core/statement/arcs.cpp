#include "core/statement/arcs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/adjustment/result/arc_summary.h"
#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/effects/catalogue.h"
#include "core/statement/result_figures.h"
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

/// The decimals of all lengths of the arcs: those that the smallest u needs.
int decimalsOfLengths(const std::vector<ArcSigma>& sigmas) {
  int decimals = 0;
  for (const ArcSigma& sigma : sigmas)
    for (const double u : {sigma.x, sigma.y, sigma.radius}) decimals = std::max(decimals, decimalsFor(u, 0));
  return std::min(decimals, mostDecimals);
}

/// The figure with u in brackets, if it has one.
std::string cellOf(const ArcFigure& figure, const ArcSummary& arc, int decimalsOfLength) {
  const int decimals = figure.decimals < 0 ? decimalsOfLength : figure.decimals;
  const double number = figure.value(arc);
  const std::string value = figure.isCount() ? displayCount(number) : displayText(number, decimals);
  return figure.sigma ? value + " (" + displayText(figure.sigma(arc), decimals) + ")" : value;
}

std::vector<Statement::Column> arcColumns() {
  std::vector<Statement::Column> columns = {{"arc", "", Role::Name}};
  for (const ArcFigure& figure : arcFigures())
    columns.push_back({figure.id, Phrase::of(figure.title), Role::Figure,
                       *figure.remark ? Phrase::of(figure.remark) : std::string()});
  return columns;
}

/// The part of the row of an axis angle that one of its arcs has for itself.
Statement::Row rowOfRepeat(const ArcFit& arc) {
  const ArcSummary own = summaryOf(arc, {});
  Cells cells = {positionName(arc.axisDeg, arc.repeat)};
  for (const ArcFigure& figure : arcFigures())
    cells.push_back(figure.isOfEachRepeat ? displayText(figure.value(own), figure.decimals) : "");
  return {.cells = std::move(cells), .isPart = true};
}

}  // namespace

Statement arcTable(const SessionFit& fit) {
  Statement statement{
      .id = "arcs", .title = Phrase::of("Arc centres and radii"), .columns = arcColumns(), .rows = {}};
  const int decimals = decimalsOfLengths(fit.sigmas);
  bool hasRepeats = false;
  for (const ArcSummary& arc : summariesByAxis(fit)) {
    Cells cells = {arcName(arc.arcs.front()->axisDeg)};
    for (const ArcFigure& figure : arcFigures()) cells.push_back(cellOf(figure, arc, decimals));
    statement.rows.push_back({cells});
    if (arc.arcs.size() < 2) continue;
    hasRepeats = true;
    for (const ArcFit* repeat : arc.arcs) statement.rows.push_back(rowOfRepeat(*repeat));
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
        {{isNamedBy(estimate.effect, estimate.name) ? effect : listed({effect, parameterName(estimate.name)}),
          displayText(estimate.value, decimals) + unit, displayText(estimate.sigma, decimals) + unit}});
  }
  return statement;
}

}  // namespace alidade
