#include "core/diagnosis/candidates/effect_components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnosis/gap/every_effect.h"
#include "core/effects/cause_ids.h"
#include "core/simulation/simulate.h"
#include "tests/support/full_leftover.h"
#include "tests/support/trial_truth.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using test::greatest;

Leftover leftoverOf(const GapModel& model) {
  return Leftover(linearise(*model.measurement, *model.fit, model.options), model.options.terms);
}

const EffectComponent& componentOf(const std::vector<EffectComponent>& components, std::string_view id) {
  return *std::ranges::find(components, id, &EffectComponent::id);
}

/// The sizes simulated by the ray tracer, in plausible sizes.
VectorXd trueWeights(const EffectComponent& component, const test::Trial& trial) {
  VectorXd weights = VectorXd::Zero(component.weights());
  for (const TrueSize& size : test::truthOf(trial).effects)
    for (Index w = 0; w < weights.size(); ++w) {
      const EffectParameter& parameter = component.effect().parameters[static_cast<std::size_t>(w)];
      if (parameter.term == size.term) weights[w] = size.value / parameter.plausible;
    }
  return weights;
}

/// A session without noise and rounding, at places of its own.
Measurement soundMeasurement(const std::string& protocol, const std::vector<TrueSize>& effects = {}) {
  Truth truth = drawTruth(3);
  truth.effects = effects;
  return *examine(*simulateWithoutNoise(*protocolByName(protocol), truth, 3)).measurement;
}

/// The readings in σ, in the order of `leftover`.
VectorXd readingsWith(const std::vector<TrueSize>& effects, const std::string& protocol,
                      const Leftover& leftover) {
  const Measurement measurement = soundMeasurement(protocol, effects);
  VectorXd readings(leftover.readings());
  for (Index i = 0; i < readings.size(); ++i) {
    const LinearReading& reading = leftover.reading(i);
    const ArcMeasurement& arc = measurement.arcs[reading.arc];
    const Sighting& sighting = arc.sightings[reading.sighting];
    // The instrument's errors at the zero rotate the line from which y counts.
    const double turned = leftover.equations().perUnknown.at(
        reading.kind, reading.number, static_cast<std::size_t>(Unknown::Kind::VerticalZero));
    const double ofZero = arc.zeroElevation.radians() *
                          ((reading.kind == ReadingKind::Vertical ? 1 / reading.sigma : 0) - turned);
    readings[i] = ofZero + (reading.kind == ReadingKind::Horizontal ? sighting.a
                            : reading.kind == ReadingKind::Vertical ? sighting.e
                                                                    : *sighting.slider)
                                   .radians() /
                               reading.sigma;
  }
  return readings;
}

// A weight of 1 is the plausible size. The reference are sessions simulated with a tenth of it more and less.
// Their texts round reading and zero by up to 5e-7″ each, 5e-6 of a plausible size at σ 2″.
TEST(EffectComponents, MoveReadingsAsTheirPlausibleSizeDoes) {
  for (const std::string protocol : {"paper", "full"}) {
    const Leftover leftover = leftoverOf(*modelOf(soundMeasurement(protocol)));
    for (const EffectComponent& component : effectComponents(leftover, {})) {
      SCOPED_TRACE(protocol + " " + std::string(component.id()));
      const MatrixXd columns = component.wholeColumns(leftover);
      const std::vector<EffectParameter>& parameters = component.effect().parameters;
      ASSERT_EQ(columns.cols(), std::ssize(parameters));
      for (Index c = 0; c < columns.cols(); ++c) {
        const EffectParameter& parameter = parameters[static_cast<std::size_t>(c)];
        const double part = 0.1 * parameter.plausible;
        const VectorXd change = (readingsWith({{parameter.term, part}}, protocol, leftover) -
                                 readingsWith({{parameter.term, -part}}, protocol, leftover)) /
                                0.2;
        EXPECT_LT(greatest(change - columns.col(c)), 1e-5);
      }
    }
  }
}

// The ray tracer's own tools computed the visibility of the true sizes, at its own places. Effects that a
// free distance absorbs are excluded, because its fit leaves the distance free.
TEST(EffectComponents, ShowAsFarAsTheRayTracerSays) {
  const std::set<std::string> apartFromDistance{"collimation", "trunnion_tilt", "vertical_index",
                                                "vertical_circle_eccentricity", "slider_eccentricity"};
  int compared = 0;
  for (const test::Trial& trial : test::trials()) {
    if (!apartFromDistance.contains(trial.kind)) continue;
    const std::vector<EffectComponent> components =
        effectComponents(leftoverOf(*modelOf(trial.measurement)), {});
    const EffectComponent& component = componentOf(components, trial.kind);
    EXPECT_NEAR(component.signatureLength(trueWeights(component, trial)), trial.visibleSigma,
                0.01 * trial.visibleSigma)
        << trial.id << " " << trial.kind;
    ++compared;
  }
  EXPECT_EQ(compared, 6);
}

// The components are in the order of the catalogue. Leaving effects out changes the others only by rounding,
// because columns are projected together.
TEST(EffectComponents, AreThoseOfTheCatalogueThatAreNotLeftOut) {
  const GapModel model = *modelOf(test::trialMeasurement("full"));
  const std::vector<std::string> leftOut{"plane_warp", "collimation", "no_effect"};
  const std::vector<EffectComponent> all = effectComponents(test::leftover(), {});
  const std::vector<const Effect*> sought = soughtEffects();
  ASSERT_EQ(all.size(), sought.size());
  for (const auto& some :
       {effectComponents(test::leftover(), leftOut), effectsBeyond(model, test::leftover(), leftOut)}) {
    auto next = some.begin();
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(all[i].id(), sought[i]->id);
      if (std::ranges::find(leftOut, all[i].id()) != leftOut.end()) continue;
      ASSERT_NE(next, some.end());
      EXPECT_EQ(next->id(), all[i].id());
      const MatrixXd gram = next->gram().topLeftCorner(all[i].columns(), all[i].columns());
      EXPECT_LT(greatest(gram - all[i].gram()), 1e-12 * all[i].gram().trace());
      ++next;
    }
    EXPECT_EQ(next, some.end());
  }
}

// The part of a trace that changes sign with the weights is linear; the other part is quadratic: fourfold for
// twice the weights. Their sum equals the trace of simulated tilts, except for third derivatives. These are
// below a hundredth of the quadratic part at 0.008 rad.
TEST(EffectComponents, BendWithTheSquareOfTheirWeights) {
  for (const std::string protocol : {"paper", "full"}) {
    const GapModel model = *modelOf(soundMeasurement(protocol));
    const Leftover leftover = leftoverOf(model);
    const std::vector<EffectComponent> straight = effectComponents(leftover, {}),
                                       bending = effectsBeyond(model, leftover, {});
    for (std::size_t i = 0; i < bending.size(); ++i) {
      const bool bends = bending[i].id() == "plane_tilt";
      EXPECT_EQ(bending[i].response() == Response::Bent, bends) << bending[i].id();
      EXPECT_NE(straight[i].response(), Response::Bent) << straight[i].id();
      EXPECT_EQ(bending[i].columns(), straight[i].columns() + (bends ? 3 : 0));
      EXPECT_EQ(bending[i].weights(), straight[i].weights());
      if (!bends) continue;
      const auto at = [&](double x, double y) {
        return bending[i].signature(leftover, Eigen::Vector2d(x, y));
      };
      const VectorXd linear = straight[i].signature(leftover, Eigen::Vector2d(0.8, -1.5));
      const VectorXd square = at(0.8, -1.5) + at(-0.8, 1.5), all = at(1.6, -3);
      const double rounding = 1e-12 * all.norm();
      EXPECT_LT(greatest((at(0.8, -1.5) - at(-0.8, 1.5)) / 2 - linear), rounding);
      EXPECT_LT(greatest(all + at(-1.6, 3) - 4 * square), rounding);
      EXPECT_LT(greatest(bending[i].products(SharedProducts(leftover, all)) -
                         bending[i].visibleColumns(leftover).transpose() * all),
                rounding * all.norm());
      const std::vector<EffectParameter>& tilts = bending[i].effect().parameters;
      const VectorXd change = readingsWith({{tilts[0].term, 0.8 * tilts[0].plausible},
                                            {tilts[1].term, -1.5 * tilts[1].plausible}},
                                           protocol, leftover) -
                              readingsWith({}, protocol, leftover);
      EXPECT_LT(greatest(leftover.visible(change) - at(0.8, -1.5)), 0.01 * greatest(square));
    }
  }
}

// With the effect in the model, its numbers are within 4 σ of the simulated ones (1 in 15000 each), in the
// unit of the catalogue, from any start. A prior of 1000 plausible sizes has no influence. A prior of a
// thousandth of a plausible size decides almost alone: 2 % of its σ and 4 % of the size are from the
// readings.
TEST(EffectComponents, TellTheirNumbersInTheUnitOfTheCatalogue) {
  const std::set<std::string> kinds{"collimation", "trunnion_tilt",  "slider_scale",
                                    "gravity_sag", "vertical_drift", "arc_ellipticity"};
  for (const test::Trial& trial : test::trials()) {
    if (!kinds.contains(trial.kind)) continue;
    SCOPED_TRACE(trial.id + " " + trial.kind);
    const GapModel model = *modelOf(trial.measurement);
    const Leftover leftover = leftoverOf(model);
    const std::vector<EffectComponent> components = effectComponents(leftover, {});
    const EffectComponent& component = componentOf(components, trial.kind);
    const VectorXd truth = trueWeights(component, trial);
    const auto with = [&](const VectorXd& start, double width) {
      GapModel after = model;
      component.addTo(after.options, leftover, start, width);
      EXPECT_EQ(std::ssize(after.options.terms), component.weights());
      after.refit();
      return component.parameters(after);
    };
    const auto free = with(0 * truth, 1000), elsewhere = with(-truth, 1000), held = with(truth, 1e-3);
    ASSERT_EQ(std::ssize(free), truth.size());
    for (std::size_t i = 0; i < free.size(); ++i) {
      const EffectParameter& parameter = component.effect().parameters[i];
      EXPECT_EQ(free[i].name, parameter.name);
      EXPECT_EQ(free[i].unit, parameter.unit);
      EXPECT_NEAR(free[i].value, truth[static_cast<Index>(i)] * parameter.plausible, 4 * free[i].sigma);
      EXPECT_NEAR(elsewhere[i].value, free[i].value, 1e-5 * free[i].sigma);
      EXPECT_NEAR(elsewhere[i].sigma, free[i].sigma, 1e-5 * free[i].sigma);
      EXPECT_LT(std::abs(held[i].value), 0.05 * std::abs(free[i].value)) << "around nothing";
      EXPECT_NEAR(held[i].sigma, 1e-3 * parameter.plausible, 2e-5 * parameter.plausible) << "its width";
    }
  }
}

// The result is independent of weights and width: the other relation is present or absent.
TEST(EffectComponents, OfTheRelationIsWhollyThere) {
  for (const test::Trial& trial : test::trials()) {
    if (trial.kind != relationId && trial.kind != "none") continue;
    GapModel model = *modelOf(trial.measurement);
    const Leftover leftover = leftoverOf(model);
    const double before = model.fit->chiSquare;
    const std::vector<EffectComponent> components = effectComponents(leftover, {});
    const EffectComponent& relation = componentOf(components, relationId);
    relation.addTo(model.options, leftover, VectorXd::Constant(1, 0.3), 50);
    model.refit();
    EXPECT_NEAR(relation.parameters(model).at(0).value, 1, 1e-4) << trial.id;
    EXPECT_EQ(model.fit->chiSquare < before, trial.kind == relationId) << trial.id;
  }
}

TEST(EffectComponents, HaveTheirWidthsTheNarrowestFirst) {
  EXPECT_TRUE(std::ranges::is_sorted(effectWidths(), std::ranges::less(), &Width::sigma));
  for (const EffectComponent& component : effectComponents(test::leftover(), {}))
    EXPECT_EQ(&component.widths(), &effectWidths()) << component.id();
}

TEST(EffectComponent, IsKnownWhereItsSizeIsInTheModel) {
  Measurement measurement = test::trialMeasurement("two-face");
  measurement.known = {{.effect = "collimation", .unit = "arcsec", .value = 3, .sigma = 6}};
  const GapModel own = *modelOf(measurement), expected = withKnownSizes(own);
  const auto of = [](const GapModel& model) {
    return componentOf(effectsBeyond(model, leftoverOf(model), {}), "collimation");
  };
  EXPECT_FALSE(of(own).isKnown());
  const EffectComponent known = of(expected);
  EXPECT_TRUE(known.isKnown());
  EXPECT_NEAR(known.usualSizes()[0], 0.2, 1e-12) << "6″ of 30″";
  JointFitOptions model = expected.options;
  known.addTo(model, leftoverOf(expected), VectorXd::Constant(1, 2), 1);
  ASSERT_EQ(model.terms.size(), 1u) << "what is known, and beyond it as wide as is plausible";
  const double arcsec = modelUnitsPer("arcsec");
  EXPECT_NEAR(model.terms[0].priorValue, 3 * arcsec, 1e-12);
  EXPECT_NEAR(model.terms[0].priorSigma, std::hypot(6, 30) * arcsec, 1e-12);
  EXPECT_NEAR(model.terms[0].start, 63 * arcsec, 1e-12);
}

}  // namespace
}  // namespace alidade
