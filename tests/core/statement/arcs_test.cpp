#include "core/statement/arcs.h"

#include <gmock/gmock.h>

#include "core/wording/size_text.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Taken {
  explicit Taken(const Session& session)
      : measurement(*examine(session).measurement), fit(fitSession(measurement)) {}

  Measurement measurement;
  SessionFit fit;
};

Session repeatedSession() {
  Session session = test::paperSession();
  session.positions.push_back(session.positions.front());
  return session;
}

TEST(ArcStatement, GivesLengthsTheDecimalsThatTheSmallestUNeeds) {
  const Statement arcs = arcTable(Taken(test::paperSession()).fit);
  ASSERT_EQ(arcs.rows.size(), 2u);
  EXPECT_THAT(arcs.rows[0].cells, ElementsAre("O1 at 0°", "−0.834 (0.063)", "1.036 (0.146)",
                                              "401.954 (0.105)", "17", "9.37", "53.35", "14"));
  EXPECT_EQ(arcs.rows[1].cells.front(), "O2 at 180°");
}

TEST(ArcStatement, GivesThePositionsAtOneAxisAngleAsParts) {
  const Statement arcs = arcTable(Taken(repeatedSession()).fit);
  ASSERT_EQ(arcs.rows.size(), 4u);
  EXPECT_EQ(arcs.rows[0].cells[4], "34");
  EXPECT_TRUE(arcs.rows[1].isPart && arcs.rows[2].isPart);
  EXPECT_THAT(arcs.rows[2].cells, ElementsAre("0° again", "", "", "", "17", "9.37", "", ""));
  EXPECT_FALSE(arcs.rows[3].isPart);
}

TEST(ArcStatement, TurnsRowsIntoColumnsAndPartsIntoRemarks) {
  const Statement arcs = arcTable(Taken(repeatedSession()).fit), turned = transposed(arcs);
  ASSERT_EQ(turned.columns.size(), 4u) << "the quantity, both arcs and the remark";
  EXPECT_EQ(turned.columns[1].title, "O1 at 0°");
  EXPECT_EQ(turned.columns[2].title, "O2 at 180°");
  ASSERT_EQ(turned.rows.size(), arcs.columns.size() - 1);
  EXPECT_THAT(turned.rows[3].cells, ElementsAre("Sightings", "34", "17", "0°: 17\n0° again: 17"));
}

TEST(ArcStatement, TellsHowFarTheCentresAreApartWhereThereAreBoth) {
  const Taken taken(test::paperSession());
  const Intersection& found = *taken.fit.intersection;
  EXPECT_THAT(arcTable(taken.fit).sentences,
              ElementsAre("Half the distance of the centres: |O1 − O2|/2 = " +
                          sizeWithExpanded(found.inPlane, found.inPlaneExpanded, "mm") + "."));
  Session session = test::paperSession();
  session.positions.erase(session.positions.begin());
  EXPECT_THAT(arcTable(Taken(session).fit).sentences, IsEmpty());
}

TEST(ArcStatement, HasNothingToTurnWithoutArcs) {
  EXPECT_THAT(transposed(arcTable({})).rows, IsEmpty());
}

}  // namespace
}  // namespace alidade
