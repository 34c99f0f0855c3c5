#include "ui/text/budget_text.h"

#include <QCoreApplication>
#include <cmath>

#include "core/base/visible_text.h"
#include "core/wording/budget.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

struct BudgetText {
  Q_DECLARE_TR_FUNCTIONS(BudgetText)
};

QString sourceText(const UncertaintyShare& share) {
  return share.effect.empty() ? qText(textOf(share)) : effectName(share.effect);
}

QString sizesAsWritten(const UncertaintyShare& share) {
  if (share.sizes.empty()) return {};
  const QString unit = unitText(share.sizes.front().unit);
  return unit.isEmpty() ? qText(sizesText(share)) : withUnit(qText(numbersText(share)), unit);
}

BudgetLine lineOf(const UncertaintyShare& share) {
  return {.source = sourceText(share),
          .sizes = sizesAsWritten(share),
          .type = qText(textOf(share.type)),
          .from = qText(share.reference.empty() ? textOf(share.from) : visibleText(share.reference)),
          .sigma = share.sigma};
}

}  // namespace

QVector<BudgetLine> budgetLines(const MeasuredIntersection& measured) {
  constexpr double negligible = 1e-2;
  const double variance = measured.estimate.sigma * measured.estimate.sigma;
  QVector<BudgetLine> lines;
  std::vector<UncertaintyShare> others;
  for (const UncertaintyShare& share : measured.budget) {
    if (share.sigma * share.sigma < negligible * variance)
      others.push_back(share);
    else
      lines.append(lineOf(share));
  }
  if (others.size() == 1) lines.append(lineOf(others.front()));
  if (others.size() < 2) return lines;
  BudgetLine together{
      .source = BudgetText::tr("%1 others").arg(others.size()), .sizes = {}, .type = {}, .from = {}};
  for (const UncertaintyShare& share : others) together.sigma = std::hypot(together.sigma, share.sigma);
  lines.append(together);
  return lines;
}

QString shareText(double part, double whole) {
  return whole > 0 ? numberText(100 * part * part / (whole * whole), 1) + QStringLiteral(" %") : notStated();
}

QString degreesOfFreedomText(double degrees) {
  constexpr double beyondCounting = 1e4;
  if (!std::isfinite(degrees)) return QStringLiteral("∞");
  return degrees > beyondCounting ? BudgetText::tr("many") : numberText(degrees, degrees < 10 ? 1 : 0);
}

}  // namespace alidade::ui
