#include "core/statement/sighting_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

NextSighting at(int axisDeg, int point, int face) {
  return {.axisDeg = axisDeg, .point = point, .face = face, .minutes = 1.5};
}

TEST(SightingsAheadStatement, JoinsTheSightingsOfAPlace) {
  const SightingsAhead ahead{
      .sightings = {at(0, 5, 1), at(0, 9, 1), at(0, 9, 1), at(0, 9, 2), at(180, 1, 2), at(180, 1, 2)},
      .minutes = 9,
      .expanded = 0.094,
      .isReached = true};
  const Statement statement = sightingsAheadStatement(ahead, 0.1);
  ASSERT_EQ(statement.rows.size(), 2u);
  EXPECT_THAT(statement.rows[0].cells, ElementsAre("0°", "4", "6", "5, 9 (2×); 9 in face 2"));
  EXPECT_THAT(statement.rows[1].cells, ElementsAre("180°", "2", "3", "1 (2×) in face 2"));
  EXPECT_THAT(
      statement.sentences,
      ElementsAre(HasSubstr("0.1 mm of Δd, whatever effect is present, needs further sightings: 6,")));
}

TEST(SightingsAheadStatement, NamesWhatWouldReachIt) {
  const SightingsAhead ahead{.sightings = {at(0, 5, 1)},
                             .minutes = 1.5,
                             .expanded = 0.2,
                             .instead = {{{}, {}, 0.2}, {{Measure::SliderReadings}, {}, 0.09}}};
  const Statement statement = sightingsAheadStatement(ahead, 0.1);
  ASSERT_EQ(statement.rows.size(), 1u) << "not the sightings, which do not reach it";
  EXPECT_THAT(statement.rows[0].cells, ElementsAre("Slider readings", "0.090"));
  EXPECT_THAT(statement.sentences, ElementsAre(HasSubstr("is not reached")));
}

}  // namespace
}  // namespace alidade
