#include "core/diagnosis/observability/further_readings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "tests/support/linearised_plan.h"
#include "tests/support/perfect_session.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

using testing::ElementsAre;
using enum Measure;

std::vector<FurtherReadings> plansOf(const GapModel& model) {
  std::vector<FurtherReadings> plans;
  eachFurtherReadings(model, [&](const FurtherReadings& plan) { plans.push_back(plan); });
  return plans;
}

std::vector<Measure> measuresOf(const GapModel& model) {
  std::vector<Measure> measures;
  for (const FurtherReadings& plan : plansOf(model)) measures.push_back(plan.measures.front());
  return measures;
}

/// Returns the readings added by one of the measures.
Measurement with(const GapModel& model, Measure measure) {
  const std::vector<FurtherReadings> plans = plansOf(model);
  return std::ranges::find(plans, std::vector{measure}, &FurtherReadings::measures)->sets.back();
}

/// Returns the largest distance of a sighted point from the circle, and of the slider from its place, mm. It
/// uses the closed forms tan a = x/L and tan e = y/√(x² + L²) or y/L.
double farthestFromCircle(const Measurement& set, const GapModel& model) {
  double farthest = 0;
  for (std::size_t arc = 0; arc < set.arcs.size(); ++arc)
    for (const Sighting& sighting : set.arcs[arc].sightings) {
      const Circle circle = model.fit->circleOf(set.arcs[arc].axisDeg == 0 ? 0 : 1);
      const double x = set.distance * std::tan(sighting.a.radians());
      const double horizontal =
          set.relation == VerticalAngleRelation::Exact ? std::hypot(x, set.distance) : set.distance;
      const double y = horizontal * std::tan(sighting.e.radians());
      farthest = std::max(farthest, std::abs(std::hypot(x - circle.x, y - circle.y) - circle.radius));
      if (!sighting.slider) continue;
      const double side = set.arcs[arc].axisDeg == 0 ? 1 : -1;
      const double apart = sighting.slider->radians() - side * std::atan2(y - circle.y, x - circle.x);
      farthest = std::max(farthest, std::abs(std::sin(apart / 2)) * 2 * circle.radius);
    }
  return farthest;
}

constexpr double rounding = 1e-8;  // mm; rounding errors of angles over metres

/// Some visits in both faces, and slider readings at every other visit, over 90° of arc.
Measurement mixedMeasurement(VerticalAngleRelation relation) {
  Measurement measurement = test::usualMeasurement();
  measurement.relation = relation;
  std::mt19937_64 generator(3);
  for (const int axisDeg : {0, 180}) {
    ArcMeasurement arc =
        test::perfectArc(measurement, {0.3, 0.1, 400}, test::spread(7, 90, axisDeg == 0 ? 90 : -90), axisDeg);
    std::vector<Sighting> rows;
    for (Sighting& sighting : arc.sightings) {
      const double s = (axisDeg == 0 ? 45 + 15 * (sighting.point - 1) : 135 - 15 * (sighting.point - 1));
      if (sighting.point % 2 == 0) sighting.slider = Angle::fromDegrees(s + 0.5);
      rows.push_back(sighting);
      if (sighting.point > 2) continue;
      rows.push_back(sighting);
      rows.back().face = 2;
    }
    arc.sightings = rows;
    test::addNoise(arc, measurement, generator);
    for (Sighting& sighting : arc.sightings) sighting.sequence = measurement.rows++;
    measurement.arcs.push_back(arc);
  }
  setMoments(measurement);
  return measurement;
}

TEST(FurtherReadings, OfferOnlyWhatASessionHasNot) {
  EXPECT_THAT(
      measuresOf(*modelOf(test::trialMeasurement("paper"))),
      ElementsAre(BothFaces, WayBack, SliderReadings, ShiftedCircle, SecondStandOff, At0Again, At180Again));
  EXPECT_THAT(measuresOf(*modelOf(test::trialMeasurement("two-face"))),
              ElementsAre(SliderReadings, ShiftedCircle, SecondStandOff, At0Again, At180Again));
  EXPECT_THAT(measuresOf(*modelOf(test::trialMeasurement("full"))),
              ElementsAre(ShiftedCircle, SecondStandOff, At0Again, At180Again));
  EXPECT_THAT(measuresOf(*modelOf(mixedMeasurement(VerticalAngleRelation::Exact))),
              ElementsAre(BothFaces, WayBack, SliderReadings, ShiftedCircle, SecondStandOff, MoreOfTheArc,
                          At0Again, At180Again));
}

// The fit of error-free readings equals the existing fit and leaves no residuals.
TEST(FurtherReadings, AreReadWithoutError) {
  for (const VerticalAngleRelation relation : {VerticalAngleRelation::Exact, VerticalAngleRelation::Planar}) {
    const Measurement measurement = mixedMeasurement(relation);
    const GapModel model = *modelOf(measurement);
    const Measurement plan = readWithoutError(model);
    EXPECT_LT(farthestFromCircle(plan, model), rounding);
    EXPECT_GT(farthestFromCircle(measurement, model), 1e-3);
    const GapModel again = *modelOf(plan);
    EXPECT_LT(again.fit->chiSquare, 1e-9);
    for (std::size_t arc = 0; arc < 2; ++arc) {
      EXPECT_NEAR(again.fit->circleOf(arc).y, model.fit->circleOf(arc).y, 1e-6);
      for (std::size_t i = 0; i < plan.arcs[arc].sightings.size(); ++i) {
        const Sighting &planned = plan.arcs[arc].sightings[i], &read = measurement.arcs[arc].sightings[i];
        EXPECT_EQ(planned.point, read.point);
        EXPECT_EQ(planned.face, read.face);
        EXPECT_EQ(planned.slider.has_value(), read.slider.has_value());
      }
    }
    for (const FurtherReadings& more : plansOf(model))
      for (const Measurement& set : more.sets) {
        EXPECT_LT(farthestFromCircle(set, model), rounding) << static_cast<int>(more.measures.front());
        std::size_t next = 0;
        for (const ArcMeasurement& arc : set.arcs)
          for (const Sighting& sighting : arc.sightings) EXPECT_EQ(sighting.sequence, next++);
        // Readings that continue the session keep its measure of time.
        EXPECT_EQ(set.rows, more.goesOn ? plan.rows : next) << static_cast<int>(more.measures.front());
      }
  }
}

// A third position after the two, with the visits of the first one at its axis. Each of its rows is later
// than all others.
TEST(FurtherReadings, MeasureAPositionAgain) {
  const GapModel model = *modelOf(mixedMeasurement(VerticalAngleRelation::Exact));
  for (const auto& [measure, axisDeg] : {std::pair(At0Again, 0), std::pair(At180Again, 180)}) {
    const Measurement set = with(model, measure);
    ASSERT_EQ(set.arcs.size(), 3u);
    const ArcMeasurement &again = set.arcs[2], &first = set.arcs[axisDeg == 0 ? 0 : 1];
    EXPECT_EQ(again.axisDeg, axisDeg);
    EXPECT_EQ(again.repeat, 2);
    ASSERT_EQ(again.sightings.size(), first.sightings.size());
    EXPECT_EQ(again.sightings.front().sequence, model.measurement->rows);
    EXPECT_EQ(again.sightings.back().a, first.sightings.back().a);
    EXPECT_FALSE(isNewSessionNeeded({measure}));
  }
  std::vector<std::vector<Measure>> combinations;
  eachCombination(model, [&](const FurtherReadings& plan) {
    if (plan.goesOn) {
      combinations.push_back(plan.measures);
      EXPECT_EQ(plan.sets.back().arcs.size(), 4u);
    }
  });
  EXPECT_EQ(combinations, (std::vector<std::vector<Measure>>{{At0Again, At180Again}}));
}

TEST(FurtherReadings, AddWhatTheirMeasureSays) {
  const GapModel model = *modelOf(mixedMeasurement(VerticalAngleRelation::Exact));
  const Measurement faces = with(model, BothFaces), back = with(model, WayBack),
                    slider = with(model, SliderReadings), more = with(model, MoreOfTheArc);
  for (std::size_t arc = 0; arc < 2; ++arc) {
    const auto& own = model.measurement->arcs[arc].sightings;
    std::map<int, std::vector<int>> facesAt;
    for (const Sighting& sighting : faces.arcs[arc].sightings)
      facesAt[sighting.point].push_back(sighting.face);
    EXPECT_EQ(facesAt.size(), 7u);
    for (const auto& [point, both] : facesAt) EXPECT_THAT(both, ElementsAre(1, 2)) << point;

    const auto& there = back.arcs[arc].sightings;
    ASSERT_EQ(there.size(), 2 * own.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
      const Sighting& mirrored = there[there.size() - 1 - i];
      EXPECT_EQ(there[i].round, i < own.size() ? 1 : 2);
      EXPECT_EQ(there[i].point, mirrored.point);
      EXPECT_EQ(there[i].face, mirrored.face);
    }

    for (const Sighting& sighting : slider.arcs[arc].sightings) EXPECT_TRUE(sighting.slider);

    // 160° in 17 places, 10° apart; the existing 90° contain nine of them.
    EXPECT_EQ(more.arcs[arc].sightings.size(), own.size() + 8);
    std::vector<int> points;
    for (std::size_t i = own.size(); i < more.arcs[arc].sightings.size(); ++i)
      points.push_back(more.arcs[arc].sightings[i].point);
    EXPECT_THAT(points, ElementsAre(8, 9, 10, 11, 12, 13, 14, 15));
  }
}

TEST(FurtherReadings, OfASetUpOfItsOwnComeBesideTheSession) {
  const GapModel model = *modelOf(test::trialMeasurement("paper"));
  for (const FurtherReadings& plan : plansOf(model)) {
    const bool isOwn = plan.measures.front() == ShiftedCircle || plan.measures.front() == SecondStandOff;
    EXPECT_EQ(plan.includesSession, isOwn) << static_cast<int>(plan.measures.front());
    ASSERT_EQ(plan.sets.size(), isOwn ? 2u : 1u);
    const Measurement &first = plan.sets.front(), &last = plan.sets.back();
    EXPECT_EQ(first.distance, model.measurement->distance);
    EXPECT_NEAR(last.distance / first.distance, plan.measures.front() == SecondStandOff ? 1.5 : 1, 1e-12);
    const Angle turn = last.arcs[1].zeroHorizontal - model.measurement->arcs[1].zeroHorizontal;
    EXPECT_NEAR(turn.degrees(), plan.measures.front() == ShiftedCircle ? 60 : 0, 1e-9);
  }
}

// Planned readings have no residuals, whatever size of an effect the model has estimated.
TEST(FurtherReadings, AreLinearisedWithoutTheEffectsOfTheModel) {
  GapModel model = *modelOf(mixedMeasurement(VerticalAngleRelation::Exact));
  model.options.terms = {{ErrorTerm::TrunnionTilt, 1e-3, 0, 2e-3}};
  model.refit();
  const std::vector<ErrorTerm> terms{ErrorTerm::GravitySag};
  for (const FurtherReadings& plan : plansOf(model)) {
    const Linearised set = test::linearisedPlan(model, plan.sets.back(), terms);
    EXPECT_EQ(set.termValues[static_cast<std::size_t>(ErrorTerm::TrunnionTilt)], 0);
    double tilt = 0, sag = 0, warp = 0;
    for (std::size_t i = 0; i < set.readings.size(); ++i) {
      EXPECT_NEAR(set.readings[i].residual, 0, 1e-4);  // σ; rounding errors
      tilt += std::abs(set.ofTerm(i, ErrorTerm::TrunnionTilt));
      sag += std::abs(set.ofTerm(i, ErrorTerm::GravitySag));
      warp += std::abs(set.ofTerm(i, ErrorTerm::WarpSine));
    }
    EXPECT_GT(tilt, 0);
    EXPECT_GT(sag, 0);
    EXPECT_EQ(warp, 0);
  }
}

// Slider, both faces and the way back together: four times the rows of the paper's plan, each with a slider
// reading, each place in both faces and in two rounds.
TEST(FurtherReadings, CombineFacesWayBackAndSlider) {
  const GapModel model = *modelOf(test::trialMeasurement("paper"));
  std::vector<std::vector<Measure>> combinations;
  eachCombination(model, [&](const FurtherReadings& plan) {
    combinations.push_back(plan.measures);
    if (plan.measures.size() < 3) return;
    const Measurement& all = plan.sets.back();
    EXPECT_EQ(all.rows, 4 * model.measurement->rows);
    for (const ArcMeasurement& arc : all.arcs) {
      EXPECT_EQ(arc.sightings.back().round, 2);
      for (const Sighting& sighting : arc.sightings) EXPECT_TRUE(sighting.slider);
    }
  });
  EXPECT_EQ(combinations.size(), 5u);
}

}  // namespace
}  // namespace alidade
