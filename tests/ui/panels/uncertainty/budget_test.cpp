#include <gmock/gmock.h>

#include <QLabel>

#include "core/evaluation/gap.h"
#include "core/statement/budget.h"
#include "core/wording/closures.h"
#include "tests/ui/support.h"
#include "ui/document/session_document.h"
#include "ui/main_window.h"
#include "ui/panels/result/result_panel.h"
#include "ui/panels/uncertainty/budget_panel.h"

// The budget page shows Δd, measured, as soon as the diagnosis is done.

namespace alidade::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

const char* const asMeasured = "Standard uncertainty of Δd, measured\n";

std::string shownBy(const QWidget* page) {
  QString texts;
  for (const QLabel* label : page->findChildren<QLabel*>())
    if (label->isVisibleTo(page)) texts += label->text() + u'\n';
  return texts.toStdString();
}

Gap paperGap() {
  return assessGap(std::make_shared<const Evaluation>(evaluateFit(paperSession())));
}

/// The page for Table I before its diagnosis.
struct PaperPage {
  PaperPage() { panel.setEvaluation(gap.evaluation); }

  Gap gap = paperGap();
  SessionDocument document;
  BudgetPanel panel{document};
};

QLabel* labelOf(const QWidget& page, const QString& text) {
  for (QLabel* label : page.findChildren<QLabel*>())
    if (label->text() == text) return label;
  return nullptr;
}

TEST(BudgetOfTheMeasurement, StandsAboveThatOfTheFitAlone) {
  PaperPage paper;
  auto& [gap, document, page] = paper;
  EXPECT_THAT(shownBy(&page), Not(HasSubstr(asMeasured)));
  page.setGap(gap);
  const std::string shown = shownBy(&page);
  for (const Statement& budget : {measuredBudget(*gap.diagnosis, 0.95), fitBudget(gap.evaluation->fit)})
    for (const Statement::Row& row : budget.rows) {
      std::string cells;
      for (std::size_t i = 0; i < row.cells.size(); ++i)
        if (budget.columns[i].role != Statement::Column::Role::Remark) cells += row.cells[i] + '\n';
      EXPECT_THAT(shown, HasSubstr(cells)) << "tool tips tell the remarks";
    }
  EXPECT_THAT(shown, HasSubstr(acrossSentence(*gap.measured())));
  EXPECT_THAT(shown, Not(HasSubstr("_"))) << "names, not ids";
  EXPECT_LT(shown.find(asMeasured), shown.find("Standard uncertainty of Δd, fit only\n"));
}

TEST(BudgetOfTheMeasurement, IsGreyWhileItIsOldAndGoesWithTheSession) {
  PaperPage paper;
  auto& [gap, document, page] = paper;
  page.setGap(gap);
  const QLabel* source = labelOf(page, QStringLiteral("other possible explanations"));
  ASSERT_TRUE(source);
  EXPECT_TRUE(source->isEnabled());
  page.setGapStale();
  EXPECT_FALSE(source->isEnabled());
  EXPECT_TRUE(source->isVisibleTo(&page)) << "what stands below stays where it is";
  page.setGap(gap);
  EXPECT_TRUE(source->isEnabled());
  page.clearGap();
  EXPECT_FALSE(source->isVisibleTo(&page));
}

TEST(BudgetOfTheMeasurement, FollowsTheDiagnosisInTheWindow) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  open.waitUntilIdle();
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  const auto* page = open->findChild<BudgetPanel*>();
  EXPECT_THAT(shownBy(page), HasSubstr(asMeasured));
  open->document().startWith({});
  EXPECT_THAT(shownBy(page), Not(HasSubstr(asMeasured)));
}

TEST(BudgetOfTheMeasurement, IsNoWiderThanItsPage) {
  PaperPage paper;
  auto& [gap, document, page] = paper;
  page.setGap(gap);
  page.resize(ResultPanel().minimumWidth(), 400);  // the width of the result page, next to it
  page.show();
  QCoreApplication::processEvents();
  EXPECT_LE(page.widget()->minimumSizeHint().width(), page.viewport()->width());
}

}  // namespace
}  // namespace alidade::ui
