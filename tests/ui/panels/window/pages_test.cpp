#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTest>
#include <algorithm>
#include <map>

#include "core/adjustment/joint/reliability.h"
#include "core/wording/budget.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"
#include "ui/panels/model/two_faces_panel.h"
#include "ui/panels/parts/data_table.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/uncertainty/budget_panel.h"
#include "ui/panels/uncertainty/reliability_panel.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/text/effect_text.h"
#include "ui/text/quantity_text.h"
#include "ui/window/pages.h"

namespace alidade::ui {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

const QString twoFaceTrial = QStringLiteral(ALIDADE_REFERENCE_DIR "/trials/sessions/241926.alidade");

std::string shownBy(const QWidget* widget) {
  QString texts;
  for (const QLabel* label : widget->findChildren<QLabel*>())
    if (label->isVisibleTo(widget)) texts += label->text() + QLatin1Char('\n');
  return texts.toStdString();
}

template <typename Page>
Page* bringToFront(OpenWindow& open) {
  auto* page = open->findChild<Page*>();
  for (PageTabs* tabs : open->pageTabs())
    if (tabs->indexOf(page) >= 0) tabs->showPage(tabs->indexOf(page));
  return page;
}

bool isOffered(OpenWindow& open, QWidget* page) {
  for (PageTabs* tabs : open->pageTabs())
    if (tabs->indexOf(page) >= 0) return tabs->isTabVisible(tabs->indexOf(page));
  return false;
}

QString cell(const QAbstractItemView* table, int row, int column) {
  return table->model()->index(row, column).data().toString();
}

/// Counts the evaluations it receives.
class CountingPage : public QWidget {
 public:
  void setEvaluation(const Evaluation&) { ++shown; }

  int shown = 0;
};

TEST(PageTabs, FeedOnlyThePageInFront) {
  PageTabs tabs;
  auto *first = new CountingPage, *second = new CountingPage;
  tabs.addPage(first, QStringLiteral("first"), showIn(first));
  tabs.addPage(second, QStringLiteral("second"), showIn(second));
  for (int i = 0; i < 3; ++i) tabs.setEvaluation(std::make_shared<const Evaluation>());
  EXPECT_EQ(first->shown, 3);
  EXPECT_EQ(second->shown, 0);
  tabs.setCurrentIndex(1);
  EXPECT_EQ(second->shown, 1);
  tabs.setCurrentIndex(0);
  EXPECT_EQ(first->shown, 3) << "nothing is new";
}

TEST(PageTabs, HideAPageThatHasNothingToShow) {
  PageTabs tabs;
  tabs.addPage(new QWidget, QStringLiteral("always"), [](const SharedEvaluation&) {});
  tabs.addPage(
      new QWidget, QStringLiteral("titled"), [](const SharedEvaluation&) {},
      [](const Evaluation& evaluation) { return !evaluation.session.title.empty(); });
  EXPECT_FALSE(tabs.isTabVisible(1));
  Evaluation titled;
  titled.session.title = "t";
  tabs.setEvaluation(std::make_shared<const Evaluation>(titled));
  EXPECT_TRUE(tabs.isTabVisible(1));
  tabs.showPage(1);
  tabs.setEvaluation(std::make_shared<const Evaluation>());
  EXPECT_FALSE(tabs.isTabVisible(1));
  EXPECT_EQ(tabs.currentIndex(), 0);
}

TEST(Budget, AccountsForTheIntersectionAndEveryCoordinate) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  open.waitUntilIdle();
  const auto* page = bringToFront<BudgetPanel>(open);
  const SessionFit fit = evaluate(paperSession()).fit;
  const std::string shown = shownBy(page);
  for (const BudgetEntry& entry : fit.intersection->budget)
    EXPECT_THAT(shown, ContainsRegex(textOf(entry.source) + "\n[^\n]+\n" +
                                     numberText(entry.sigma, 3).toStdString() + "\n"))
        << "a digit more than u = 0.10 mm needs";
  // The combined uncertainties of the centres are those of the fit.
  for (const ArcSigma& sigma : fit.sigmas)
    for (const double figure : {sigma.x, sigma.y})
      EXPECT_THAT(shown, HasSubstr(numberText(figure, 4).toStdString()));
  EXPECT_THAT(shown,
              HasSubstr("correlation with R\n" + signedNumberText(fit.sigmas[0].radiusX, 2).toStdString() +
                        "\n" + signedNumberText(fit.sigmas[0].radiusY, 2).toStdString()));
}

TEST(Budget, SaysSoWhereThereIsNoFit) {
  OpenWindow open;
  EXPECT_THAT(shownBy(bringToFront<BudgetPanel>(open)), HasSubstr("No arc is fitted yet"));
}

TEST(Reliability, ListsEveryReadingAndFollowsTheTable) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  open.waitUntilIdle();
  auto* page = bringToFront<ReliabilityPanel>(open);
  const auto* table = page->findChild<DataTable*>();
  const SessionFit fit = evaluate(paperSession()).fit;
  ASSERT_EQ(table->model()->rowCount(), 68 + 5) << "readings, two zeros of each position, the distance";
  const AdjustedReading& reading = fit.joint.readings.front();
  const Reliability first = reliabilityOf(reading, detectionIn(fit.joint, fit.noise.factor));
  EXPECT_EQ(cell(table, 0, 6), numberText(reading.standardised(fit.noise.factor), 2));
  EXPECT_EQ(cell(table, 0, 7), numberText(reading.redundancy, 2));
  EXPECT_EQ(cell(table, 0, 8), QStringLiteral("89.8"));
  EXPECT_EQ(cell(table, 0, 9), signedNumberText(first.influence, 4));

  open->reveal({.position = 1, .reading = 4, .field = "vertical"});
  const QModelIndexList selected = table->selectionModel()->selectedRows();
  ASSERT_EQ(selected.size(), 2) << "both circles of the row";
  for (const QModelIndex& index : selected) {
    EXPECT_EQ(cell(table, index.row(), 0), QStringLiteral("180°"));
    EXPECT_EQ(cell(table, index.row(), 1), QStringLiteral("5"));
  }
}

// An error of β0 turns its arc about the theodolite by the same angle. At L = 2405 mm it lifts it by 0.0117
// mm per ″, except for the arc's own height. Δd is half the difference of both arcs. On a zenith circle a β0
// too large lifts, so at 180° it lowers Δd.
TEST(Reliability, ShowsWhatNothingChecks) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  open.waitUntilIdle();
  auto* page = bringToFront<ReliabilityPanel>(open);
  EXPECT_THAT(shownBy(page), HasSubstr("Nothing checks the pointing zeros and the distance"));
  auto* table = page->findChild<DataTable*>();
  const auto rowOf = [&](int row) {
    QStringList texts;
    for (int column = 0; column < table->model()->columnCount(); ++column)
      texts.push_back(cell(table, row, column));
    return texts.join(u'|');
  };
  EXPECT_EQ(rowOf(69), QStringLiteral("0°|—|—|—|vertical zero|—|—|0.00|none|+0.0058 per ″"));
  EXPECT_EQ(rowOf(71), QStringLiteral("180°|—|—|—|vertical zero|—|—|0.00|none|−0.0058 per ″"));
  EXPECT_TRUE(rowOf(72).startsWith(QStringLiteral("—|—|—|—|distance|—|—|0.00|none|")))
      << rowOf(72).toStdString();
  const int before = open->currentTable()->currentIndex().row();
  table->setCurrentIndex(table->model()->index(72, 0));
  QTest::keyClick(table, Qt::Key_Return);
  EXPECT_EQ(open->currentTable()->currentIndex().row(), before) << "it is no row of readings";
}

TEST(Reliability, ListsAZeroThatAllPositionsHaveOnce) {
  Session session = paperSession();
  session.geometry.pointingZeros = "one";
  session.positions[1].zero = session.positions[0].zero;
  OpenWindow open;
  open->document().startWith(session);
  open.waitUntilIdle();
  auto* table = bringToFront<ReliabilityPanel>(open)->findChild<DataTable*>();
  EXPECT_EQ(table->model()->rowCount(), 71);  // 68 readings, α0, β0 and L
  EXPECT_EQ(cell(table, 68, 0), QStringLiteral("all"));
  EXPECT_EQ(cell(table, 69, 4), QStringLiteral("vertical zero"));
  EXPECT_EQ(cell(table, 70, 4), QStringLiteral("distance"));
}

// Three places determine a circle without redundancy.
TEST(Reliability, SaysWhereTooFewReadingsAreThereToTestOne) {
  Session session = paperSession();
  for (Position& position : session.positions)
    position.readings = {position.readings[0], position.readings[8], position.readings[16]};
  OpenWindow open;
  open->document().startWith(session);
  open.waitUntilIdle();
  auto* page = bringToFront<ReliabilityPanel>(open);
  EXPECT_THAT(shownBy(page), HasSubstr("Too few readings"));
  const auto* table = page->findChild<DataTable*>();
  EXPECT_EQ(cell(table, 0, 6), QStringLiteral("—"));
  EXPECT_EQ(cell(table, 0, 8), QStringLiteral("none"));
}

TEST(Reliability, LeadsBackToTheReading) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  open.waitUntilIdle();
  auto* table = bringToFront<ReliabilityPanel>(open)->findChild<DataTable*>();
  table->setCurrentIndex(table->model()->index(6, 0));
  QTest::keyClick(table, Qt::Key_Return);
  EXPECT_EQ(open->currentTable()->currentIndex().row(), 3) << "two readings to a row";
  table->selectDataRows({6, 7});
  table->copy();
  EXPECT_EQ(QApplication::clipboard()->text().count(QLatin1Char('\n')), 1);
}

TEST(TwoFacesPage, IsThereWhereThereAreTwoFaces) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  open.waitUntilIdle();
  EXPECT_FALSE(isOffered(open, open->findChild<TwoFacesPanel*>()));
  ASSERT_TRUE(open->files().open(twoFaceTrial));
  open.waitUntilIdle();
  const auto* page = bringToFront<TwoFacesPanel>(open);
  EXPECT_TRUE(isOffered(open, open->findChild<TwoFacesPanel*>()));
  const auto faces = compareFaces(*examine(open->document().session()).measurement);
  ASSERT_TRUE(faces);
  const std::string errors = shownBy(page);
  for (const InstrumentError& error : {faces->collimation, *faces->trunnionTilt, faces->index}) {
    const double u = error.sigma.arcseconds();
    const int decimals = decimalsFor(u);
    EXPECT_THAT(errors,
                HasSubstr(QStringLiteral("\n%1 (%2)\n")
                              .arg(numberText(error.value.arcseconds(), decimals), numberText(u, decimals))
                              .toStdString()));
  }
  EXPECT_THAT(errors, HasSubstr("× " + numberText(faces->vertical.ratio(), 2).toStdString() + "\n"));
  const auto* table = page->findChild<DataTable*>();
  ASSERT_EQ(table->model()->rowCount(), static_cast<int>(faces->visits.size()));
  EXPECT_EQ(cell(table, 0, 4), signedNumberText(faces->visits[0].doubleCollimation.arcseconds(), 1));
}

TEST(Pages, AreReachedByTheKeyboard) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(twoFaceTrial));
  open.waitUntilIdle();
  const QList<PageTabs*> tabs = open->pageTabs();
  QTest::keyClick(open.window.get(), Qt::Key_2, Qt::ControlModifier);
  EXPECT_EQ(tabs[0]->currentIndex(), 1);
  QTest::keyClick(open.window.get(), Qt::Key_6, Qt::ControlModifier);
  EXPECT_EQ(tabs[1]->currentIndex(), 2);
  EXPECT_TRUE(qobject_cast<DataTable*>(QApplication::focusWidget()));
}

/// Keys that every keyboard types with Ctrl alone.
TEST(Pages, HaveAShortcutEachThatIsADigitOrALetter) {
  OpenWindow open;
  std::map<QString, int> uses;
  for (const QAction* action : open->findChildren<QAction*>())
    if (!action->shortcut().isEmpty()) ++uses[action->shortcut().toString()];
  std::size_t shown = 0;
  for (const PageTabs* tabs : open->pageTabs()) shown += static_cast<std::size_t>(tabs->count());
  EXPECT_EQ(shown, allPages().size());
  for (const PageInfo& info : allPages()) {
    const QString keys = QString::fromLatin1(info.keys);
    EXPECT_TRUE(QRegularExpression(QStringLiteral("^Ctrl\\+[0-9A-Z]$")).match(keys).hasMatch()) << info.keys;
    EXPECT_EQ(uses[keys], 1) << info.keys << " is the shortcut of " << info.id << " alone";
  }
}

TEST(Pages, BelowThePictureTakeItsRoom) {
  OpenWindow open;
  const auto* result = open->pageTabs()[0];
  const int before = open->pageTabs()[1]->height();
  QTest::keyClick(open.window.get(), Qt::Key_0, Qt::ControlModifier);
  QCoreApplication::processEvents();
  EXPECT_FALSE(result->isVisible());
  EXPECT_GT(open->pageTabs()[1]->height(), before + 100);
  QTest::keyClick(open.window.get(), Qt::Key_0, Qt::ControlModifier);
  EXPECT_TRUE(result->isVisible());
}

}  // namespace
}  // namespace alidade::ui
