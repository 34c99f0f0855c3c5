#include "core/simulation/series_trial.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace alidade {
namespace {

using testing::HasSubstr;

const std::string storedSeries = ALIDADE_REFERENCE_DIR "/series";

std::string fingerprint(const std::vector<ScoredSeries>& all) {
  std::string text;
  for (const ScoredSeries& one : all) text += one.seal.id + " " + one.seal.kind + " " + one.answer + "\n";
  return text;
}

// The ray tracer's series, of which single sessions name the effect half of the time.
TEST(SeriesTrial, NamesWhatSessionsShareAndWhoseItIs) {
  const auto all = scoreStoredSeries(storedSeries, 0);
  ASSERT_TRUE(all) << all.problem().text();
  ASSERT_EQ(all->size(), 10u);
  std::size_t empty = 0;
  for (const ScoredSeries& one : *all) {
    const bool isEmpty = one.seal.kind == "none";
    empty += isEmpty ? 1 : 0;
    EXPECT_EQ(one.isAlarm, !isEmpty) << one.seal.id << ": " << one.answer;
    if (isEmpty) continue;
    EXPECT_TRUE(one.isNamed) << one.seal.id << ": " << one.answer;
    EXPECT_TRUE(one.isOwnerRight) << one.seal.id << ": " << one.answer;
  }
  EXPECT_EQ(empty, 2u);
}

TEST(SeriesTrial, DoesNotDependOnTheNumberOfThreads) {
  const auto one = scoreDrawnSeries(4, 70, 1), three = scoreDrawnSeries(4, 70, 3);
  ASSERT_TRUE(one && three);
  EXPECT_EQ(fingerprint(*one), fingerprint(*three));
}

// One of 16 drawn series may be missed: their effects are visible by 6 to 10 σ, uncatalogued ones by 8 and
// more.
TEST(SeriesTrial, OfDrawnSeriesNearlyAllAreAnsweredRightly) {
  const auto all = scoreDrawnSeries(16, 400, 0);
  ASSERT_TRUE(all) << all.problem().text();
  std::size_t wrong = 0, spoiled = 0, unknown = 0;
  for (const ScoredSeries& one : *all) {
    EXPECT_FALSE(one.seal.kind == "none" && one.isAlarm) << one.seal.id << ": " << one.answer;
    wrong += one.seal.kind != "none" && !(one.isNamed && one.isOwnerRight) ? 1 : 0;
    spoiled += one.seal.spoiled ? 1 : 0;
    unknown += one.seal.kind.starts_with("unknown_") ? 1 : 0;
    EXPECT_FALSE(one.isNoiseOfAll) << one.seal.id << ": " << one.answer;
  }
  EXPECT_LE(wrong, 1u);
  EXPECT_GT(spoiled, 0u);
  EXPECT_GT(unknown, 0u);
}

TEST(SeriesTrial, DrawsTheSameSeriesOfTheSameSeed) {
  const auto a = drawSeriesTrial(9), b = drawSeriesTrial(9);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->sessions, b->sessions);
  EXPECT_GE(a->sessions.size(), 8u);
  EXPECT_LE(a->sessions.size(), 12u);
}

TEST(SeriesTrial, TellsFoldersOfSeriesFromThoseOfSessions) {
  EXPECT_TRUE(holdsSeries(storedSeries));
  EXPECT_FALSE(holdsSessions(storedSeries));
  EXPECT_FALSE(holdsSeries(ALIDADE_REFERENCE_DIR "/trials"));
  EXPECT_TRUE(holdsSessions(ALIDADE_REFERENCE_DIR "/trials"));
  const test::TemporaryFolder folder;
  EXPECT_FALSE(holdsSeries(folder.path().string()));
  folder.file("truth.json", R"({"s": {"kind": "none", "shared": "none", "sessions": {"1": {}}}})");
  EXPECT_TRUE(holdsSeries(folder.path().string()));
  const auto scored = scoreStoredSeries(folder.path().string(), 1);
  ASSERT_FALSE(scored);
  EXPECT_THAT(scored.problem().text(), HasSubstr("1.alidade"));
}

}  // namespace
}  // namespace alidade
