#include "ui/start/start_page.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QTest>

#include "tests/ui/support.h"
#include "ui/main_window.h"
#include "ui/start/samples.h"

namespace alidade::ui {
namespace {

TEST(StartPage, LeadsToASampleAndIsGone) {
  OpenWindow open;
  open->showStart();
  auto* start = open->findChild<StartPage*>();
  ASSERT_TRUE(start && start->isVisible());
  emit start->sampleWanted(QString::fromLatin1(allSamples().front().name));
  open.waitUntilIdle();
  EXPECT_FALSE(start->isVisible());
  EXPECT_FALSE(open->document().session().positions[0].readings.empty());
  EXPECT_TRUE(open->document().path().isEmpty()) << "the sample itself is never written over";
}

QAction* actionOf(OpenWindow& open, const QKeySequence& keys) {
  for (QAction* action : open->findChildren<QAction*>())
    if (action->shortcuts().contains(keys)) return action;
  return nullptr;
}

TEST(StartPage, IsThereAgainOnceASessionIsClosed) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("two-causes.alidade"))));
  open.waitUntilIdle();
  ASSERT_TRUE(actionOf(open, QKeySequence(QStringLiteral("Ctrl+W"))));
  actionOf(open, QKeySequence(QStringLiteral("Ctrl+W")))->trigger();
  const auto* start = open->findChild<StartPage*>();
  ASSERT_TRUE(start && start->isVisible());
  EXPECT_TRUE(open->document().path().isEmpty());
}

TEST(MainWindowActions, RedoHasBothUsualShortcuts) {
  OpenWindow open;
  const QAction* redo = actionOf(open, QKeySequence(QStringLiteral("Ctrl+Y")));
  ASSERT_TRUE(redo);
  EXPECT_EQ(redo, actionOf(open, QKeySequence(QStringLiteral("Ctrl+Shift+Z"))));
}

TEST(StartPage, EverySampleOpens) {
  EXPECT_GE(allSamples().size(), 5U);
  for (const Sample& sample : allSamples()) {
    EXPECT_TRUE(readSample(QString::fromLatin1(sample.name))) << sample.name;
    EXPECT_GT(std::string(sample.shows).size(), 10U) << sample.name;
  }
}

TEST(StartPage, GivesWayToWhatIsTyped) {
  OpenWindow open;
  open->showStart();
  auto* start = open->findChild<StartPage*>();
  emit start->sessionWanted(QStringLiteral("2"));
  EXPECT_FALSE(start->isVisible());
  auto* entry = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->objectName(), QStringLiteral("geometry.distance_mm"));
  EXPECT_EQ(entry->text(), QStringLiteral("2"));
}

}  // namespace
}  // namespace alidade::ui
