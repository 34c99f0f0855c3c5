#include "core/statement/budget.h"

#include <cmath>
#include <utility>

#include "core/base/phrase.h"
#include "core/base/quantity_text.h"
#include "core/base/visible_text.h"
#include "core/wording/across.h"
#include "core/wording/attainable.h"
#include "core/wording/budget.h"
#include "core/wording/effect_name.h"

namespace alidade {

namespace {

using Role = Statement::Column::Role;
using Cells = std::vector<std::string>;

std::string percentText(double share) {
  return displayShortest(std::round(share * 1e6) / 1e4) + " %";
}

std::string nameOf(const UncertaintyShare& share) {
  return share.effect.empty() ? textOf(share) : effectName(share.effect);
}

/// A row of the budget of Δd, measured.
struct ShareRows {
  double sigma = 0;  ///< of the whole, mm
  int decimals = decimalsFor(sigma) + 1;

  Cells cells(std::string name, double part, Cells size = {"", "", ""}) const {
    return {std::move(name),    std::move(size[0]),          std::move(size[1]),
            std::move(size[2]), displayText(part, decimals), varianceShare(part, sigma)};
  }
  Cells cells(const UncertaintyShare& share) const {
    return cells(nameOf(share), share.sigma,
                 {sizesWithSign(share), textOf(share.type),
                  share.reference.empty() ? textOf(share.from) : visibleText(share.reference)});
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
                                  {"u", "u (mm)"},
                                  {"share", Phrase::of("share")}},
                      .rows = sharesOf(measured)};
  const ShareRows table{found.sigma};
  statement.rows.push_back({table.cells(Phrase::of("combined, u"), found.sigma), true});
  statement.rows.push_back({{Phrase::of("expanded, U"), "", "",
                             Phrase::of("%1 coverage, %2 degrees of freedom", percentText(coverage),
                                        degreesOfFreedomText(found.degreesOfFreedom)),
                             displayText(found.expanded, table.decimals), ""},
                            true});
  statement.sentences = {
      Phrase::of("Δd, measured, includes every catalogued effect, limited by these readings or by its "
                 "plausible size."),
      acrossSentence(measured)};
  if (std::string attainable = attainableSentence(diagnosis.attainable); !attainable.empty())
    statement.sentences.push_back(std::move(attainable));
  statement.note = Phrase::of(
      "1σ: how large each effect may plausibly be; share: of the variance. A: by the scatter of these "
      "readings; B: by other knowledge.");
  return statement;
}

Statement fitBudget(const Intersection& intersection) {
  const double sigma = intersection.sigma;
  const int decimals = decimalsFor(sigma) + 1;
  Statement statement{.id = "budget_fit",
                      .title = Phrase::of("Standard uncertainty of Δd, fit only"),
                      .columns = {{"source", Phrase::of("Source"), Role::Name},
                                  {"remark", "", Role::Remark},
                                  {"u", "u (mm)"},
                                  {"share", Phrase::of("share")}},
                      .rows = {}};
  const auto cells = [&](const std::string& name, double part) {
    return Cells{name, "", displayText(part, decimals), varianceShare(part, sigma)};
  };
  for (const BudgetEntry& entry : intersection.budget)
    statement.rows.push_back({cells(textOf(entry.source), entry.sigma)});
  statement.rows.push_back({cells(Phrase::of("combined, u"), sigma), true});
  statement.rows.push_back({{Phrase::of("expanded, U"),
                             Phrase::of("%1 coverage, k = %2", percentText(intersection.coverage),
                                        displayText(intersection.coverageFactor, 2)),
                             displayText(intersection.expanded, decimals), ""},
                            true});
  return statement;
}

std::string varianceShare(double part, double whole) {
  return whole > 0 ? displayText(100 * part * part / (whole * whole), 1) + " %" : "—";
}

std::string degreesOfFreedomText(double degrees) {
  constexpr double beyondCounting = 1e4, fewDegrees = 10;
  if (!std::isfinite(degrees)) return "∞";
  return degrees > beyondCounting ? Phrase::of("many") : displayText(degrees, degrees < fewDegrees ? 1 : 0);
}

}  // namespace alidade
