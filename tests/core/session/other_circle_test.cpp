#include "core/session/other_circle.h"

#include <gtest/gtest.h>

#include "core/effects/catalogue.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

namespace alidade {
namespace {

Measurement readWith(VerticalCircle circle, const EffectParameter& parameter, double size) {
  Truth truth = drawTruth(4);
  truth.verticalCircle = circle;
  truth.verticalZero = Angle::fromDegrees(circle == VerticalCircle::Zenith ? 90 : 0);
  truth.effects = {{parameter.term, size}};
  return *examine(*simulateWithoutNoise(*protocolByName("two-face"), truth, 4)).measurement;
}

const EffectParameter& parameterOf(const Effect& effect, const std::string& name) {
  return *std::ranges::find(effect.parameters, name, &EffectParameter::name);
}

// Circles of both kinds read the same directions if their errors are converted. The simulation has a forward
// model for each kind; its readings are exact to their last digit, 1e-9″ after reduction.
TEST(OtherCircle, HasTheSameDirectionsWithConvertedErrors) {
  for (const char* id :
       {"vertical_index", "vertical_circle_eccentricity", "vertical_graduation", "vertical_drift"}) {
    const Effect& effect = *effectById(id);
    for (const EffectParameter& parameter : effect.parameters) {
      const auto other = onOtherCircle(id, parameter.name);
      ASSERT_TRUE(other) << id;
      const Measurement zenith = readWith(VerticalCircle::Zenith, parameter, 7),
                        elevation = readWith(VerticalCircle::Elevation, parameterOf(effect, other->parameter),
                                             other->sign * 7),
                        same = withZenithCircle(elevation);
      EXPECT_EQ(same.verticalCircle, VerticalCircle::Zenith);
      for (std::size_t arc = 0; arc < 2; ++arc) {
        EXPECT_NEAR(same.arcs[arc].zeroVertical.arcseconds(), zenith.arcs[arc].zeroVertical.arcseconds(),
                    1e-6);
        for (std::size_t i = 0; i < zenith.arcs[arc].sightings.size(); ++i)
          ASSERT_NEAR(same.arcs[arc].sightings[i].e.arcseconds(),
                      zenith.arcs[arc].sightings[i].e.arcseconds(), 1e-6)
              << id << ' ' << parameter.name << ' ' << i;
      }
    }
  }
}

TEST(OtherCircle, LeavesOtherErrorsAlone) {
  EXPECT_FALSE(onOtherCircle("collimation", ""));
  EXPECT_FALSE(onOtherCircle("horizontal_circle_eccentricity", "sine"));
}

TEST(OtherCircle, ConvertsKnownSizesThereAndBack) {
  const std::vector<KnownSize> known = {{"vertical_index", "", "30", "0.5", "arcsec"},
                                        {"vertical_circle_eccentricity", "sine", "-2", "1", "arcsec"},
                                        {"vertical_index", "", "", "1", "arcsec"},
                                        {"collimation", "", "4", "1", "arcsec"}};
  const std::vector<KnownSize> other = onOtherCircle(known);
  EXPECT_EQ(other[0].value, "-30");
  EXPECT_EQ(other[1].parameter, "cosine");
  EXPECT_EQ(other[1].value, "2");
  EXPECT_EQ(other[3], known[3]);
  EXPECT_EQ(onOtherCircle(other), known);
}

}  // namespace
}  // namespace alidade
