#include "ui/commands/change_positions.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <algorithm>
#include <stdexcept>

#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/document/session_document.h"
#include "ui/main_window.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"

namespace alidade::ui {
namespace {

/// The paper's session without the positions at these axes, in a file.
class PartialFile {
 public:
  explicit PartialFile(const std::vector<std::string>& without) {
    Session session = paperSession();
    std::erase_if(session.positions, [&](const Position& position) {
      return std::find(without.begin(), without.end(), position.axisDeg) != without.end();
    });
    QFile file(path());
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(writeSession(session)));
  }

  QString path() const { return m_folder.filePath(QStringLiteral("partial.alidade")); }

 private:
  QTemporaryDir m_folder;
};

std::vector<std::string> axesOf(const Session& session) {
  std::vector<std::string> axes;
  for (const Position& position : session.positions) axes.push_back(position.axisDeg);
  return axes;
}

using Axes = std::vector<std::string>;

QAction* addAction(const OpenWindow& open, int axisDeg) {
  auto* action = open.window->findChild<QAction*>(QStringLiteral("add position %1").arg(axisDeg));
  if (!action) throw std::runtime_error("no such action");
  return action;
}

/// The menu entries: "Add Position at 0°", "Measure 180° Again", in brackets if disabled.
QStringList offers(const OpenWindow& open) {
  QStringList texts;
  for (const int axisDeg : {0, 180}) {
    const QAction* action = addAction(open, axisDeg);
    texts.append(action->isEnabled() ? action->text() : QStringLiteral("(%1)").arg(action->text()));
  }
  return texts;
}

QPushButton& addButton(const OpenWindow& open, int axisDeg) {
  return *open.window->findChild<QPushButton*>(QStringLiteral("add position %1").arg(axisDeg));
}

QStringList shownTabs(const PositionTabs& tabs) {
  QStringList titles;
  for (int tab = 0; tab < tabs.count(); ++tab) {
    if (tabs.isTabVisible(tab)) titles.append(tabs.tabText(tab).remove(QLatin1Char('&')));
  }
  return titles;
}

TEST(AddPosition, PutsZeroFirstAndTakesItBack) {
  const PartialFile file({"0"});
  SessionDocument document;
  ASSERT_FALSE(document.load(file.path()));
  const Session before = document.session();
  addPosition(document, 0);
  EXPECT_EQ(axesOf(document.session()), Axes({"0", "180"}));
  EXPECT_TRUE(document.session().positions[0].readings.empty());
  EXPECT_EQ(document.session().positions[1], before.positions[0]);
  EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("Add position at 0°"));
  changeField(document, {.position = 0, .field = "pointing_zero.vertical"}, "90 00 00");
  const Session after = document.session();
  document.undoStack().setIndex(0);
  EXPECT_EQ(document.session(), before);
  EXPECT_FALSE(document.isModified());
  document.undoStack().setIndex(2);
  EXPECT_EQ(document.session(), after);
}

TEST(AddPosition, KnowsAnAxisHoweverItIsTyped) {
  SessionDocument document;
  changeField(document, {.position = 1, .field = "axis_deg"}, "180.0");
  EXPECT_TRUE(hasPosition(document.session(), 180));
  changeField(document, {.position = 1, .field = "axis_deg"}, "90");
  EXPECT_FALSE(hasPosition(document.session(), 180));
}

TEST(AddPosition, MeasuresNoneAgainWhileTheOtherIsMissing) {
  const PartialFile file({"180"});
  SessionDocument document;
  ASSERT_FALSE(document.load(file.path()));
  addPosition(document, 0);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST(AddPosition, PutsWhatIsMeasuredAgainLastAndTakesItBack) {
  SessionDocument document;
  document.startWith(paperSession());
  const Session before = document.session();
  addPosition(document, 0);
  EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("Measure 0° again"));
  addPosition(document, 180);
  addPosition(document, 0);
  EXPECT_EQ(axesOf(document.session()), Axes({"0", "180", "0", "180", "0"}));
  Position untyped;
  untyped.axisDeg = "0";
  EXPECT_EQ(document.session().positions.back(), untyped) << "nothing is typed for the user";
  EXPECT_EQ(document.session().positions[0], before.positions[0]);
  document.undoStack().undo();
  EXPECT_EQ(axesOf(document.session()), Axes({"0", "180", "0", "180"}));
  document.undoStack().setIndex(0);
  EXPECT_EQ(document.session(), before);
  EXPECT_FALSE(document.isModified());
}

// With a repeat the file has the order of measurement, and 0° may come later.
TEST(AddPosition, LeavesTheOrderOfTheFile) {
  Session session = paperSession();
  std::swap(session.positions[0], session.positions[1]);
  SessionDocument document;
  document.startWith(session);
  addPosition(document, 0);
  EXPECT_EQ(axesOf(document.session()), Axes({"180", "0", "0"}));
  addPosition(document, 180);
  EXPECT_EQ(axesOf(document.session()), Axes({"180", "0", "0", "180"}));
}

TEST(AddPosition, IsOfferedWhereOneIsMissing) {
  const PartialFile file({"180"});
  OpenWindow open;
  const auto& tabs = *open->findChild<PositionTabs*>();
  EXPECT_EQ(shownTabs(tabs), QStringList({QStringLiteral("Axis at 0°"), QStringLiteral("Axis at 180°")}));
  EXPECT_EQ(offers(open),
            QStringList({QStringLiteral("Measure 0° Again"), QStringLiteral("Measure 180° Again")}));
  ASSERT_TRUE(open->files().open(file.path()));
  open.waitUntilIdle();
  EXPECT_EQ(shownTabs(tabs), QStringList({QStringLiteral("Axis at 0°"), QStringLiteral("180° missing")}));
  EXPECT_EQ(offers(open),
            QStringList({QStringLiteral("(Measure 0° Again)"), QStringLiteral("Add Position at 180°")}));
}

TEST(AddPosition, FollowsAnAxisThatIsTypedOver) {
  OpenWindow open;
  const auto& tabs = *open->findChild<PositionTabs*>();
  changeField(open->document(), {.position = 1, .field = "axis_deg"}, "90");
  open.waitUntilIdle();
  EXPECT_EQ(shownTabs(tabs).last(), QStringLiteral("180° missing"));
  EXPECT_EQ(offers(open).last(), QStringLiteral("Add Position at 180°"));
  open->undo();
  open.waitUntilIdle();
  EXPECT_EQ(shownTabs(tabs).last(), QStringLiteral("Axis at 180°"));
  EXPECT_EQ(offers(open).last(), QStringLiteral("Measure 180° Again"));
  changeField(open->document(), {.position = 1, .field = "axis_deg"}, "0");
  open.waitUntilIdle();
  EXPECT_EQ(shownTabs(tabs), QStringList({QStringLiteral("Axis at 0°"), QStringLiteral("0° again"),
                                          QStringLiteral("180° missing")}));
}

TEST(AddPosition, LeadsFromTheButtonToThePointingZeroAndBack) {
  const PartialFile file({"180"});
  OpenWindow open;
  ASSERT_TRUE(open->files().open(file.path()));
  auto& tabs = *open->findChild<PositionTabs*>();
  tabs.showPosition(1);
  ASSERT_TRUE(addButton(open, 180).isVisible());
  addButton(open, 180).click();
  open.waitUntilIdle();
  EXPECT_EQ(axesOf(open->document().session()), Axes({"0", "180"}));
  EXPECT_EQ(tabs.currentIndex(), 1);
  EXPECT_TRUE(open->findChild<QLineEdit*>(QStringLiteral("pointing_zero.horizontal 1"))->hasFocus());
  tabs.table(1)->selectCell(0, ReadingColumn::Horizontal);
  typeInto(*tabs.table(1), QStringLiteral("3415224"));
  ASSERT_EQ(open->document().undoStack().count(), 2);
  open->undo();
  open->undo();
  open.waitUntilIdle();
  EXPECT_EQ(axesOf(open->document().session()), Axes({"0"}));
  EXPECT_TRUE(addButton(open, 180).isVisible());
  EXPECT_EQ(open->currentTable(), nullptr);
  open->redo();
  open->redo();
  open.waitUntilIdle();
  EXPECT_EQ(open->document().session().positions.at(1).readings.size(), 1u);
  EXPECT_EQ(open->currentTable(), tabs.table(1));
  EXPECT_FALSE(open->currentTable()->actions().isEmpty()) << "has its menu";
}

TEST(AddPosition, FillsASessionThatHasNone) {
  const PartialFile file({"0", "180"});
  const QTemporaryDir folder;
  OpenWindow open;
  ASSERT_TRUE(open->files().open(file.path()));
  open.waitUntilIdle();
  const auto& tabs = *open->findChild<PositionTabs*>();
  EXPECT_EQ(shownTabs(tabs), QStringList({QStringLiteral("0° missing"), QStringLiteral("180° missing")}));
  EXPECT_TRUE(addButton(open, 0).isVisible());
  addAction(open, 180)->trigger();
  addAction(open, 0)->trigger();
  open.waitUntilIdle();
  EXPECT_EQ(axesOf(open->document().session()), Axes({"0", "180"}));
  EXPECT_EQ(tabs.currentIndex(), 0);
  open.dialogs->savePath = folder.filePath(QStringLiteral("filled.alidade"));
  ASSERT_TRUE(open->files().saveAs());
  const Result<Session> saved = loadSession(open.dialogs->savePath.toStdString());
  ASSERT_TRUE(saved);
  EXPECT_EQ(*saved, open->document().session());
  open->document().undoStack().setIndex(0);
  open.waitUntilIdle();
  EXPECT_EQ(shownTabs(tabs).size(), 2);
  EXPECT_EQ(open->currentTable(), nullptr);
}

}  // namespace
}  // namespace alidade::ui
