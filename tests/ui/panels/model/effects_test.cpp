#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTest>
#include <QTreeWidget>
#include <nlohmann/json.hpp>

#include "core/effects/catalogue.h"
#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/main_window.h"
#include "ui/panels/model/effects_panel.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/text/effect_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

using testing::ElementsAre;
using Ids = std::vector<std::string>;

/// A window with the paper's table and the page of effects in front.
struct EffectsBench {
  EffectsBench() {
    if (!open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))))
      throw std::runtime_error("sample");
    open.waitUntilIdle();
    open->pageTabs()[0]->showPage(2);
    list = open->findChild<EffectsPanel*>()->findChild<QTreeWidget*>();
  }

  QTreeWidgetItem* item(const char* name) const {
    const auto found = list->findItems(QString::fromUtf8(name), Qt::MatchExactly);
    return found.isEmpty() ? nullptr : found.first();
  }
  const Ids& effects() { return open->document().session().model.effects; }
  void toggle(const char* name) {
    list->setCurrentItem(item(name));
    QTest::keyClick(list, Qt::Key_Space);
    QCoreApplication::processEvents();
    open.waitUntilIdle();
  }

  OpenWindow open;
  QTreeWidget* list;
};

TEST(Effects, AreChosenWithTheKeyboardAndEstimated) {
  EffectsBench bench;
  EXPECT_EQ(bench.list->topLevelItemCount(), static_cast<int>(effectCatalogue().size()));
  bench.toggle("Trunnion tilt");
  EXPECT_THAT(bench.effects(), ElementsAre("trunnion_tilt"));
  const SessionFit fit = evaluate(bench.open->document().session()).fit;
  ASSERT_EQ(fit.effects.size(), 1u);
  EXPECT_EQ(bench.item("Trunnion tilt")->text(1),
            withStandardUncertainty(fit.effects[0].value, fit.effects[0].sigma, QStringLiteral("″")));
  bench.toggle("Vertical axis tilt");
  EXPECT_EQ(bench.item("Vertical axis tilt")->childCount(), 2) << "a row for each of its numbers";
  bench.toggle("Trunnion tilt");
  EXPECT_THAT(bench.effects(), ElementsAre("vertical_axis_tilt"));
  EXPECT_EQ(bench.item("Trunnion tilt")->text(1), QString());
}

TEST(Effects, AreUndoneAndSaved) {
  EffectsBench bench;
  bench.toggle("Collimation");
  EXPECT_EQ(bench.open->document().undoStack().undoText(), QStringLiteral("Estimate collimation"));
  EXPECT_THAT(readSession(writeSession(bench.open->document().session()))->model.effects,
              ElementsAre("collimation"));
  bench.open->pageTabs()[0]->showPage(0);
  bench.open->undo();
  bench.open.waitUntilIdle();
  EXPECT_TRUE(bench.effects().empty());
  EXPECT_EQ(bench.item("Collimation")->checkState(0), Qt::Unchecked);
  EXPECT_EQ(bench.open->pageTabs()[0]->currentIndex(), 2) << "undo leads to what it changed";
  bench.open->redo();
  EXPECT_EQ(bench.item("Collimation")->checkState(0), Qt::Checked);
}

TEST(Effects, KeepWhatTheCatalogueDoesNotKnowUntilItIsTakenAway) {
  EffectsBench bench;
  setEffect(bench.open->document(), "moonlight", true);
  bench.open.waitUntilIdle();
  ASSERT_TRUE(bench.item("moonlight"));
  EXPECT_EQ(bench.item("moonlight")->checkState(0), Qt::Checked);
  EXPECT_FALSE(bench.item("moonlight")->icon(0).isNull());
  bench.toggle("Collimation");
  EXPECT_THAT(bench.effects(), ElementsAre("moonlight", "collimation"));
  bench.toggle("moonlight");
  EXPECT_FALSE(bench.item("moonlight"));
  EXPECT_THAT(bench.effects(), ElementsAre("collimation"));
}

TEST(Effects, ThatAreChosenAlreadyLeaveNoUndoStep) {
  SessionDocument document;
  setEffect(document, "collimation", false);
  EXPECT_EQ(document.undoStack().count(), 0);
  setEffect(document, "collimation", true);
  setEffect(document, "collimation", true);
  EXPECT_EQ(document.undoStack().count(), 1);
}

}  // namespace
}  // namespace alidade::ui
