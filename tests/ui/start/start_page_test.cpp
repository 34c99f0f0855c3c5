#include "ui/start/start_page.h"

#include <gtest/gtest.h>

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
  open.settle();
  EXPECT_FALSE(start->isVisible());
  EXPECT_FALSE(open->document().session().positions[0].readings.empty());
  EXPECT_TRUE(open->document().path().isEmpty()) << "the sample itself is never written over";
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
