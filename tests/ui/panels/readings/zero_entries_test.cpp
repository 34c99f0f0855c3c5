#include "ui/panels/readings/zero_entries.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>

#include "core/simulation/simulate.h"
#include "tests/ui/report/printed.h"
#include "tests/ui/shown_texts.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;

QLineEdit& entry(OpenWindow& open, const char* field, int position = 0) {
  return *open->findChild<QLineEdit*>(
      QStringLiteral("pointing_zero.%1 %2").arg(QLatin1String(field)).arg(position));
}

QToolButton& toggle(OpenWindow& open, int position = 0) {
  return *open->findChild<QToolButton*>(QStringLiteral("further zeros %1").arg(position));
}

QLabel& mean(OpenWindow& open, int position = 0) {
  return *open->findChild<QLabel*>(QStringLiteral("mean zero %1").arg(position));
}

/// Zeros sighted in both faces, before and after.
Session sightedInFull() {
  Truth truth = drawTruth(7);
  truth.sightsZerosInFull = true;
  return *simulate(*protocolByName("paper"), truth, 7);
}

TEST(ZeroEntries, ShowFurtherSightingsOnDemand) {
  OpenWindow open;
  open->document().startWith(paperSession());
  open.waitUntilIdle();
  EXPECT_FALSE(entry(open, "after.horizontal").isVisible());
  EXPECT_TRUE(mean(open).isHidden());
  QTest::mouseClick(&toggle(open), Qt::LeftButton);
  EXPECT_TRUE(entry(open, "face_2.horizontal").isVisible());
  EXPECT_FALSE(entry(open, "face_2.horizontal", 1).isHidden()) << "of every position alike";
  expectAllVisible(*open.window, QStringLiteral("with further sightings"));

  typeInto(entry(open, "after.horizontal"), QStringLiteral("332 32 56"));
  open.waitUntilIdle();
  EXPECT_TRUE(mean(open).isHidden()) << "half a sighting is none";
  typeInto(entry(open, "after.vertical"), QStringLiteral("89 59 58"));
  open.waitUntilIdle();
  EXPECT_THAT(
      mean(open).text().toStdString(),
      HasSubstr("Mean of 2 sightings: α0 332°32′55.0″ ± 1.4″, β0 89°59′57.5″ ± 1.4″ (1σ); the zero moved "
                "by 2.0″ (α0) and 1.0″ (β0)"));
  EXPECT_EQ(open->document().session().positions[0].zero.after.vertical, "89 59 58");
}

TEST(ZeroEntries, AreShownWhereASessionHasThemAndWhereUndoLeads) {
  OpenWindow open;
  open->document().startWith(sightedInFull());
  open.waitUntilIdle();
  EXPECT_TRUE(entry(open, "after_face_2.vertical").isVisible());
  EXPECT_THAT(mean(open, 1).text().toStdString(), HasSubstr("Mean of 4 sightings"));
  entry(open, "after.vertical").setFocus();
  entry(open, "after.vertical").selectAll();
  typeInto(entry(open, "after.vertical"), QStringLiteral("400 00 00"));
  open.waitUntilIdle();
  EXPECT_THAT(entry(open, "after.vertical").toolTip().toStdString(), HasSubstr("lies outside"));
  QTest::mouseClick(&toggle(open), Qt::LeftButton);
  EXPECT_FALSE(entry(open, "after.vertical").isVisible());
  open->undo();
  EXPECT_TRUE(entry(open, "after.vertical").isVisible());
}

TEST(ZeroEntries, ArePrinted) {
  const Session session = sightedInFull();
  const QString printed = Printed(session).text();
  EXPECT_TRUE(printed.contains(QStringLiteral("Sighted again before the readings in face 2: ")));
  EXPECT_TRUE(printed.contains(QStringLiteral("Mean of 4 sightings: α0 ")));
}

}  // namespace
}  // namespace alidade::ui
