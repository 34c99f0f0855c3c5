#include "core/series/history/history_sentences.h"

#include <gmock/gmock.h>

namespace alidade {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

DatedValue at(const std::string& date, double day, double value) {
  return {date, day, value, 0.01, 0.01, {}};
}

// Of two dates neither steps nor a trend can be tested.
TEST(HistorySentences, OfTwoDatesTellTheirDifference) {
  const History apart = historyOf({at("2024-01-01", 0, 0.300), at("2024-01-01", 0, 0.304),
                                   at("2024-02-01", 31, 0.600), at("2024-02-01", 31, 0.596)});
  EXPECT_NEAR(apart.twoDates->value, 0.296, 1e-12);
  EXPECT_NEAR(apart.twoDates->u, 0.01, 1e-12);  // each mean of two values has 0.01/√2
  const std::vector<std::string> sentences = historySentences(apart, "mm");
  EXPECT_THAT(sentences,
              Contains("The values of 2024-01-01 and 2024-02-01 differ by 0.296 mm ± 0.020 mm: "
                       "measure on a third date to tell a change from understated uncertainties."));
  EXPECT_THAT(sentences, Not(Contains(HasSubstr("Neither a step"))));
}

TEST(HistorySentences, OfTwoDatesDoNotCallADifferenceAgreement) {
  std::vector<DatedValue> values;
  for (int i = 0; i < 10; ++i)
    values.push_back(at(i < 5 ? "2024" : "2025", i < 5 ? 0 : 366, i < 5 ? 0 : 0.016));
  const History slightly = historyOf(values);
  ASSERT_GT(*slightly.chance, leastChance);
  EXPECT_THAT(historySentences(slightly, ""), Contains(HasSubstr("2024 and 2025 differ by 0.016 ± 0.012")));
  EXPECT_THAT(historySentences(slightly, ""), Not(Contains(HasSubstr("agree"))));
  for (DatedValue& value : values) value.value /= 2;
  EXPECT_THAT(historySentences(historyOf(values), ""), Contains(HasSubstr("agree within")));
}

TEST(HistorySentences, OfOneDateOrThreeSayWhatWasTested) {
  const History one = historyOf({at("2024-01-01", 0, 0.3), at("2024-01-01", 0, 0.4)});
  EXPECT_FALSE(one.twoDates);
  EXPECT_THAT(historySentences(one, ""), Contains(HasSubstr("All values are of one date")));
  const History three = historyOf({at("2024", 0, 0.30), at("2025", 366, 0.35), at("2026", 731, 0.31)});
  EXPECT_FALSE(three.twoDates);
  EXPECT_THAT(historySentences(three, ""), Contains(HasSubstr("Neither a step nor a trend")));
}

}  // namespace
}  // namespace alidade
