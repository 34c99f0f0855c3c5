#include "core/diagnosis/gap/every_effect.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/diagnosis/gap/gap_size.h"
#include "core/effects/catalogue.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

bool has(const std::vector<EstimatedTerm>& terms, ErrorTerm term) {
  return std::ranges::find(terms, term, &EstimatedTerm::term) != terms.end();
}

TEST(EveryEffect, IsAsLargeAsIsPlausible) {
  const std::vector<EstimatedTerm> terms = everyEffect(test::trialMeasurement("paper-slider"));
  std::size_t numbers = 0;
  for (const Effect& effect : effectCatalogue())
    for (const EffectParameter& parameter : effect.parameters) {
      const bool isModel = effect.response == Response::AllOrNothing;
      EXPECT_EQ(has(terms, parameter.term), !isModel) << effect.id;
      if (isModel) continue;
      ++numbers;
      const EstimatedTerm& term = *std::ranges::find(terms, parameter.term, &EstimatedTerm::term);
      EXPECT_EQ(term.priorSigma, plausibleSize(parameter));
      EXPECT_EQ(term.priorValue, 0);
    }
  EXPECT_EQ(terms.size(), numbers);
}

TEST(EveryEffect, HasThoseOfTheSliderWhereItIsRead) {
  EXPECT_FALSE(has(everyEffect(test::trialMeasurement("paper")), ErrorTerm::SliderScale));
  EXPECT_TRUE(has(everyEffect(test::trialMeasurement("full")), ErrorTerm::SliderSine));
}

// A term that is already in the model keeps its width if this width is larger, or is the session's own.
TEST(EveryEffect, NarrowsNothingDown) {
  Measurement measurement = test::trialMeasurement("two-face");
  measurement.effects = {"collimation"};
  GapModel model = *closedModelOf(*modelOf(measurement));
  model.options.terms.push_back({ErrorTerm::TrunnionTilt, 1});
  model.options.terms.push_back({ErrorTerm::GravitySag, 1e-6});
  const GapModel with = withEveryEffect(model);
  const auto widthOf = [](const GapModel& of, ErrorTerm term) {
    return std::ranges::find(of.options.terms, term, &EstimatedTerm::term)->priorSigma;
  };
  EXPECT_EQ(widthOf(with, ErrorTerm::Collimation), widthOf(model, ErrorTerm::Collimation));
  EXPECT_EQ(widthOf(with, ErrorTerm::TrunnionTilt), 1);
  EXPECT_EQ(widthOf(with, ErrorTerm::GravitySag), 0.05);
  EXPECT_EQ(with.options.terms.size(), everyEffect(measurement).size());
  EXPECT_GT(estimateOf(with)->sigma, estimateOf(*closedModelOf(*modelOf(measurement)))->sigma);
}

TEST(EveryEffect, IsAsLargeAsIsKnownOfIt) {
  Measurement measurement = test::trialMeasurement("paper");
  measurement.known = {{.effect = "plane_offset", .unit = "mm", .value = 0.3, .sigma = 0.02}};
  const std::vector<EstimatedTerm> terms = everyEffect(measurement);
  const EstimatedTerm& offset = *std::ranges::find(terms, ErrorTerm::PlaneOffset, &EstimatedTerm::term);
  EXPECT_EQ(offset.priorValue, 0.3);
  EXPECT_NEAR(offset.priorSigma, 0.02, 1e-12);
  EXPECT_EQ(terms.size(), everyEffect(test::trialMeasurement("paper")).size());
}

TEST(EveryEffect, IsTakenAsLinearInManyRows) {
  Measurement measurement;
  measurement.rows = 5000;
  EXPECT_FALSE(isLarge(measurement));
  measurement.rows = 5001;
  EXPECT_TRUE(isLarge(measurement));
}

TEST(KnownTerms, StandInTheModelAsKnownAsTheyAre) {
  Measurement measurement = test::trialMeasurement("two-face");
  const GapModel own = *modelOf(measurement);
  EXPECT_TRUE(withKnownSizes(own).options.terms.empty());
  measurement.known = {{.effect = "collimation", .unit = "arcsec", .value = 3, .sigma = 0.5},
                       {.effect = "slider_scale", .unit = "1", .sigma = 1e-5}};
  const GapModel expected = withKnownSizes(*modelOf(measurement));
  ASSERT_EQ(expected.options.terms.size(), 1u) << "no slider is read";
  const EstimatedTerm& term = expected.options.terms[0];
  EXPECT_EQ(term.term, ErrorTerm::Collimation);
  EXPECT_NEAR(term.priorValue, 3 * modelUnitsPer("arcsec"), 1e-12);
  EXPECT_NEAR(term.priorSigma, 0.5 * modelUnitsPer("arcsec"), 1e-12);
}

TEST(KnownTerms, TakeThePlaceOfWhatIsPlausibleInTheSessionsOwnModel) {
  Measurement measurement = test::trialMeasurement("two-face");
  measurement.effects = {"collimation", "trunnion_tilt"};
  measurement.known = {{.effect = "collimation", .unit = "arcsec", .value = 3, .sigma = 0.5}};
  const GapModel expected = withKnownSizes(*modelOf(measurement));
  ASSERT_EQ(expected.options.terms.size(), 2u);
  EXPECT_NEAR(expected.options.terms[0].priorSigma, 0.5 * modelUnitsPer("arcsec"), 1e-12);
  EXPECT_EQ(expected.options.terms[1].priorSigma, 30 * modelUnitsPer("arcsec"));
}

}  // namespace
}  // namespace alidade
