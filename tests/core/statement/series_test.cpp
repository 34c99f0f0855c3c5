#include "core/statement/series.h"

#include <gmock/gmock.h>

#include "core/statement/gap.h"
#include "core/wording/diagnosis_sentence.h"
#include "tests/support/trunnion_series.h"

namespace alidade {
namespace {

using test::trunnionOfTwo;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(SeriesStatement, NamesCausesWithOwnerSizeAndLookAlikes) {
  const Statement causes = seriesCauses(trunnionOfTwo());
  ASSERT_EQ(causes.rows.size(), 1u);
  EXPECT_THAT(causes.rows[0].cells, ElementsAre("Trunnion tilt", "instrument T-1", "12.0″ (u 1.5)", "2",
                                                "97 %", "2.0", "2.8", "plane warp"));
  EXPECT_THAT(causes.rows[0].cells, testing::SizeIs(causes.columns.size()));
}

TEST(SeriesStatement, GivesSizesThatDifferAsParts) {
  SeriesDiagnosis series = trunnionOfTwo();
  series.causes[0].isDrifting = true;
  series.causes[0].sizes = {{0, {{"tilt", 10, 1.5, "arcsec"}}}, {1, {{"tilt", 14, 1.5, "arcsec"}}}};
  const Statement causes = seriesCauses(series);
  ASSERT_EQ(causes.rows.size(), 3u);
  EXPECT_EQ(causes.rows[0].cells[2], "12.0″ (u 1.5), changing between sessions");
  EXPECT_TRUE(causes.rows[1].isPart && causes.rows[2].isPart);
  EXPECT_EQ(causes.rows[2].cells[0], "second");
  EXPECT_EQ(causes.rows[2].cells[2], "14.0″ (u 1.5)");
  EXPECT_THAT(causes.rows[2].cells, testing::SizeIs(causes.columns.size()));
}

TEST(SeriesStatement, NamesThePatternWithoutACause) {
  SeriesDiagnosis series = trunnionOfTwo();
  series.causes.clear();
  series.pattern = SharedPattern{.follows = "radius along the guideway", .order = 7, .sessions = {0, 1}};
  const Statement causes = seriesCauses(series);
  ASSERT_EQ(causes.rows.size(), 1u);
  EXPECT_EQ(causes.rows[0].cells[0], "Pattern: radius along the guideway (7 periods in a turn)");
  EXPECT_EQ(causes.rows[0].cells[5], "—") << "each session has its own";
  EXPECT_THAT(causes.rows[0].cells, testing::SizeIs(causes.columns.size()));
}

TEST(SeriesStatement, SaysTheVerdictsOfSessionsInWords) {
  const Statement sessions = seriesSessions(trunnionOfTwo());
  ASSERT_EQ(sessions.rows.size(), 2u);
  EXPECT_EQ(sessions.rows[1].cells[0], "second");
  EXPECT_EQ(sessions.rows[1].cells[4], "One cause: collimation");
  EXPECT_EQ(sessions.rows[1].id, "6");
}

TEST(SeriesStatement, TakesTheVerdictWithinTheSeriesFromTheWholeDiagnosis) {
  SeriesDiagnosis series = trunnionOfTwo();
  series.sessions[0].diagnosis.verdict = DiagnosisVerdict::SeveralCauses;
  series.sessions[0].diagnosis.hasMoreCausesThanSeparable = true;
  EXPECT_EQ(seriesSessions(series).rows[0].cells[5], headlineOf(series.sessions[0].diagnosis));
  EXPECT_THAT(seriesSessions(series).rows[0].cells[5], testing::HasSubstr("ore causes than"));
}

TEST(SeriesStatement, DividesTheGapInWords) {
  const Statement where = gapWhere({{"frame", "guideway", 0.795},
                                    {"frame", "noise", 0.205},
                                    {"frame", "time", 0.002},
                                    {"session", "alone", 1},
                                    {"instrument", "T-1", 0.4},
                                    {"instrument", "T-2", 0.6}});
  EXPECT_THAT(where.sentences,
              ElementsAre("belongs to: guideway (80 %), noise (20 %)", "instrument: T-1 (40 %), T-2 (60 %)"));
  EXPECT_THAT(where.rows, IsEmpty());
}

TEST(SeriesStatement, IsEmptyWithoutSessions) {
  for (const Statement& statement :
       {seriesCauses({}), seriesSessions({}), seriesAdvice({}), seriesUndetectable({}), gapWhere({})}) {
    EXPECT_THAT(statement.rows, IsEmpty()) << statement.id;
    EXPECT_THAT(statement.sentences, IsEmpty()) << statement.id;
  }
}

}  // namespace
}  // namespace alidade
