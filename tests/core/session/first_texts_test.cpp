#include "core/session/first_texts.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace alidade {
namespace {

TEST(FirstTexts, KeepTheTextOfEachFieldThatWasChanged) {
  FirstTexts texts;
  EXPECT_TRUE(texts.empty());
  texts.set("vertical", "88 16 49");
  texts.set("point", "3");
  texts.set("vertical", "88 16 50");
  EXPECT_EQ(texts.all(), (FirstTexts::Texts{{"point", "3"}, {"vertical", "88 16 50"}}));
  EXPECT_EQ(texts.of("vertical"), "88 16 50");
  EXPECT_EQ(texts.of("horizontal"), std::nullopt);
  texts.drop("horizontal");
  texts.drop("vertical");
  EXPECT_FALSE(texts.empty());
  texts.drop("point");
  EXPECT_TRUE(texts.empty());
  EXPECT_EQ(texts, FirstTexts());
}

TEST(FirstTexts, OfACopyAreItsOwn) {
  FirstTexts texts;
  texts.set("vertical", "88 16 49");
  FirstTexts copy = texts;
  copy.set("point", "3");
  copy.drop("vertical");
  EXPECT_EQ(texts.all(), (FirstTexts::Texts{{"vertical", "88 16 49"}}));
  EXPECT_EQ(copy.all(), (FirstTexts::Texts{{"point", "3"}}));
  texts.drop("vertical");
  EXPECT_EQ(copy.all(), (FirstTexts::Texts{{"point", "3"}}));
}

/// A job reads and releases its copy while the window changes its own. A copy that is not shared is changed
/// in place. The test is for the thread sanitizer.
TEST(FirstTexts, OfACopyAreReadElsewhereWhileTheirOwnChange) {
  std::vector<FirstTexts> rows(500);
  for (int turn = 0; turn < 20; ++turn) {
    const std::string text = std::to_string(turn);
    for (FirstTexts& row : rows) row.set("vertical", text);
    std::size_t alike = 0;
    std::jthread job([copies = rows, &alike, text]() mutable {
      for (FirstTexts& row : copies) {
        alike += row.of("vertical") == text ? 1 : 0;
        row = {};
      }
    });
    for (FirstTexts& row : rows) row.set("vertical", "changed since");
    job.join();
    EXPECT_EQ(alike, rows.size());
  }
}

}  // namespace
}  // namespace alidade
