#include "core/adjustment/gross_errors/entry_errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::Not;

std::vector<std::string> textsOf(std::string_view typed) {
  std::vector<std::string> texts;
  for (const IntendedText& intended : intendedTexts(typed)) texts.push_back(intended.text);
  return texts;
}

EntryError errorTo(std::string_view typed, std::string_view intended) {
  const auto texts = intendedTexts(typed);
  const auto found = std::ranges::find(texts, intended, &IntendedText::text);
  if (found == texts.end()) throw std::runtime_error("not among the texts meant: " + std::string(intended));
  return found->error;
}

TEST(EntrySlips, SwapDigitsWithinAndAcrossParts) {
  EXPECT_EQ(errorTo("341°25'24\"", "341°52'24\""), EntryError::DigitsSwapped);
  EXPECT_EQ(errorTo("341 52 24", "345 12 24"), EntryError::DigitsSwapped);
}

TEST(EntrySlips, ChangeOneDigitToAnyOther) {
  EXPECT_EQ(errorTo("341°52'24\"", "341°52'29\""), EntryError::OneDigitWrong);
  EXPECT_EQ(errorTo("88°16'49.5\"", "88°16'49.1\""), EntryError::OneDigitWrong);
  EXPECT_EQ(errorTo("379.859gon", "379.359gon"), EntryError::OneDigitWrong);
}

TEST(EntrySlips, GoOneUnitOffWithCarries) {
  EXPECT_EQ(errorTo("341°52'24\"", "342°52'24\""), EntryError::DegreeOff);
  EXPECT_EQ(errorTo("341°52'24\"", "342°02'24\""), EntryError::TenMinutesOff);
  EXPECT_EQ(errorTo("341°00'24\"", "340°59'24\""), EntryError::MinuteOff);
  EXPECT_EQ(errorTo("341°52'54\"", "341°53'04\""), EntryError::TenSecondsOff);
  EXPECT_EQ(errorTo("0°00'05\"", "359°59'55\""), EntryError::TenSecondsOff);
}

TEST(EntrySlips, KeepTheStyleOfTheTypedText) {
  EXPECT_THAT(textsOf("100-09-57.1"), Contains("99-59-57.1"));
  EXPECT_THAT(textsOf("3415254"), Contains("3415304"));
  EXPECT_THAT(textsOf("8° 59′ 57″"), Contains("9° 09′ 57″"));
  EXPECT_THAT(textsOf("203°25'11\""), Not(Contains("023°25'11\""))) << "nobody who types 203 types 023";
}

TEST(EntrySlips, ListEachTextOnceAndNeverTheTypedOne) {
  std::vector<std::string> texts = textsOf("341°52'24\"");
  EXPECT_THAT(texts, Not(Contains("341°52'24\"")));
  std::ranges::sort(texts);
  EXPECT_TRUE(std::ranges::adjacent_find(texts) == texts.end());
}

// Ten seconds off may also be one wrong digit. Each of the five neighbours in 81°48'23" differs.
TEST(EntrySlips, AddUpTheWaysToOneText) {
  const auto texts = intendedTexts("81°48'23\"");
  const auto both = std::ranges::find(texts, "81°48'32\"", &IntendedText::text);
  const auto single = std::ranges::find(texts, "81°48'29\"", &IntendedText::text);
  const auto tens = std::ranges::find(texts, "81°48'33\"", &IntendedText::text);
  ASSERT_TRUE(both != texts.end() && single != texts.end() && tens != texts.end());
  EXPECT_NEAR(tens->prior, entryErrorShare(EntryError::TenSecondsOff) / 2 + single->prior, 1e-12);
  EXPECT_NEAR(both->prior, entryErrorShare(EntryError::DigitsSwapped) / 5, 1e-12);
}

TEST(EntrySlips, LeaveWhatIsNoAngleToItsDigits) {
  EXPECT_THAT(textsOf(""), ::testing::IsEmpty());
  EXPECT_THAT(textsOf("abc"), ::testing::IsEmpty());
  EXPECT_EQ(errorTo("341°72'24\"", "341°27'24\""), EntryError::DigitsSwapped);
}

TEST(EntrySlips, ShareOutAllOfTheProbability) {
  double sum = 0;
  for (const EntryError error :
       {EntryError::DigitsSwapped, EntryError::OneDigitWrong, EntryError::DegreeOff,
        EntryError::TenMinutesOff, EntryError::MinuteOff, EntryError::TenSecondsOff,
        EntryError::CirclesSwapped, EntryError::WrongFace, EntryError::NeighbouringRow})
    sum += entryErrorShare(error);
  EXPECT_NEAR(sum, 1, 1e-12);
}

}  // namespace
}  // namespace alidade::test
