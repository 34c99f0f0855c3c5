#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/forms/form_readings.h"
#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/kept_form.h"
#include "core/diagnosis/own_effect_check.h"
#include "core/diagnosis/plan_review.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/simulation/truth_text.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using testing::HasSubstr;

constexpr double arcsecond = std::numbers::pi / 648000;

OwnEffect effectOf(const std::string& formula, const std::vector<std::string>& amplitudes,
                   const std::string& plausible) {
  OwnEffect effect{.id = "own", .formula = formula};
  for (const std::string& name : amplitudes) effect.parameters.push_back({name, plausible, ""});
  return effect;
}

std::shared_ptr<const OwnEffects> only(const OwnEffect& effect) {
  std::vector<Problem> problems;
  auto effects = examineOwnEffects({effect}, problems);
  EXPECT_TRUE(problems.empty()) << problems.front().text();
  return effects;
}

/// A session by a protocol, simulated with some effects.
Session sessionWith(const OwnEffect& effect, const std::vector<std::string>& sizes, std::uint64_t seed = 7,
                    const std::string& protocol = "full") {
  Truth truth = drawTruth(seed);
  truth.own = only(effect);
  for (const std::string& size : sizes) EXPECT_FALSE(addEffect(truth, size)) << size;
  return *simulate(*protocolByName(protocol), truth, seed);
}

Measurement measurementOf(Session session, const OwnEffect* effect) {
  if (effect) session.ownEffects = {*effect};
  return *examine(session).measurement;
}

struct Derived {
  GapModel model;
  Leftover leftover;
  FormReadings readings;
};

Derived derivedOf(const Measurement& measurement) {
  GapModel model = *modelOf(measurement);
  Leftover leftover(linearise(*model.measurement, *model.fit, model.options), model.options.terms);
  FormReadings readings = formReadings(leftover, *model.measurement, *model.fit);
  return {std::move(model), std::move(leftover), std::move(readings)};
}

VectorXd ownColumn(const Derived& at, std::size_t parameter = 0) {
  return at.leftover.column(at.model.measurement->own->entries()[0].terms[parameter]);
}

/// Greatest difference, relative to the greatest entry.
double difference(const VectorXd& one, const VectorXd& other) {
  return (one - other).cwiseAbs().maxCoeff() / other.cwiseAbs().maxCoeff();
}

// The catalogue's derivatives equal those of its formulas, up to rounding of automatic differentiation: 1e-9.
TEST(OwnColumns, AreThoseOfTheCatalogue) {
  struct Same {
    const char* formula;
    ErrorTerm term;
  };
  for (const auto& [formula, term] :
       {Same{"radial = A*cos(2*s)", ErrorTerm::EllipticityCosine},
        Same{"radial = A*sin(3*s)", ErrorTerm::LobingSine}, Same{"across = A*sin(2*s)", ErrorTerm::WarpSine},
        Same{"y = -A*sin(s)", ErrorTerm::GravitySag},
        Same{"tangential = -A*cos(s)*position", ErrorTerm::ArmSag},
        Same{"vertical = A*(e/10°)^2", ErrorTerm::VerticalRefraction},
        Same{"horizontal = A*t", ErrorTerm::HorizontalDrift},
        Same{"vertical = -A*t", ErrorTerm::VerticalDrift},
        Same{"horizontal = A*sin(horizontal_circle)", ErrorTerm::HorizontalCircleSine},
        Same{"vertical = -A*face*cos(vertical_circle)", ErrorTerm::VerticalCircleCosine},
        Same{"horizontal = A*face*tan(e)", ErrorTerm::TrunnionTilt},
        Same{"vertical = -A*face", ErrorTerm::VerticalIndex},
        Same{"slider = A*sin(s)", ErrorTerm::SliderSine}}) {
    const OwnEffect own = effectOf(formula, {"A"}, "1");
    const Measurement measurement = measurementOf(sessionWith(own, {}), &own);
    const Derived derived = derivedOf(measurement);
    // The argument depends on the place of the arc in the fit: s of the sag counts from the horizon.
    const bool isExact = term != ErrorTerm::TrunnionTilt;
    EXPECT_LT(difference(ownColumn(derived), derived.leftover.column(term)), isExact ? 1e-9 : 1e-4)
        << formula;
  }
}

// The columns of a formula equal those of the form with the same definition, computed in another way.
TEST(OwnColumns, AreThoseOfForms) {
  struct Same {
    Form form;
    const char* formula;
    std::vector<std::string> amplitudes;
  };
  Form dent{.carrier = FormCarrier::Radial, .function = FormFunction::Bump, .of = FormArgument::S};
  dent.numbers = {83 * std::numbers::pi / 180, 4 * std::numbers::pi / 180};
  Form wave{.carrier = FormCarrier::X, .of = FormArgument::S, .order = 5};
  Form power{.carrier = FormCarrier::Vertical,
             .function = FormFunction::Power,
             .of = FormArgument::Elevation,
             .order = 3};
  Form settling{
      .carrier = FormCarrier::Horizontal, .function = FormFunction::Exponential, .of = FormArgument::T};
  settling.numbers = {0.2, 0};
  Form leg{.carrier = FormCarrier::Z, .function = FormFunction::Hysteresis, .of = FormArgument::Leg};
  Form circle{.carrier = FormCarrier::Horizontal,
              .of = FormArgument::HorizontalCircle,
              .turnsWithFace = true,
              .order = 3};
  for (const auto& [form, formula, amplitudes] :
       {Same{dent, "radial = A*bump(s, 83°, 4°)", {"A"}},
        Same{wave, "x = A*cos(5*s) + B*sin(5*s)", {"A", "B"}}, Same{power, "vertical = A*(e/10°)^3", {"A"}},
        Same{settling, "horizontal = A*exp(-t/0.2)", {"A"}}, Same{leg, "z = A*leg", {"A"}},
        Same{circle, "horizontal = face*A*cos(3*alpha) + face*B*sin(3*alpha)", {"A", "B"}}}) {
    const OwnEffect own = effectOf(formula, amplitudes, "1");
    const Measurement measurement = measurementOf(sessionWith(own, {}), &own);
    const Derived derived = derivedOf(measurement);
    const MatrixXd columns = formColumns(derived.readings, form);
    const double unit = form.isMillimetres() ? 1 : arcsecond;
    // A form uses adjusted directions; the model's directions count from a zero with its estimated error.
    for (Index c = 0; c < columns.cols(); ++c)
      EXPECT_LT(difference(unit * ownColumn(derived, static_cast<std::size_t>(c)), columns.col(c)), 1e-4)
          << formula;
  }
}

// By central differences of refitted readings: a large effect of any kind is what the model has.
TEST(OwnEffects, ThatWerePutInAreEstimated) {
  for (const auto& [formula, unit] :
       {std::pair("radial = A*bump(s, 83°, 8°)", "mm"), std::pair("across = A*cos(5*s)", "mm"),
        std::pair("horizontal = A*cos(5*s)", "arcsec"), std::pair("vertical = A*sin(9*e)*face", "arcsec"),
        std::pair("tangential = A*sin(6*s)*leg", "mm"), std::pair("slider = A*sin(4*s)", "arcsec"),
        std::pair("orientation = A*exponential(t, 0.2)", "arcsec")}) {
    const bool isLength = std::string(unit) == "mm";
    const double size = isLength ? 0.3 : 30;
    const OwnEffect own = effectOf(formula, {"A"}, isLength ? "1" : "100");
    Session session = sessionWith(own, {"own:own=" + std::to_string(size)});
    session.model.effects = {"own:own"};
    const Measurement measurement = measurementOf(session, &own);
    const SessionFit fit = fitSession(measurement);
    ASSERT_TRUE(fit.joint.converged()) << formula;
    ASSERT_EQ(fit.effects.size(), 1u);
    EXPECT_EQ(fit.effects[0].effect, "own:own");
    EXPECT_EQ(fit.effects[0].unit, unit);
    EXPECT_LT(std::abs(fit.effects[0].value - size), 4 * fit.effects[0].sigma) << formula;
    EXPECT_LT(fit.effects[0].sigma, size / 3) << formula << ": it shows";
    const double perFreedom = fit.joint.chiSquare / fit.joint.degreesOfFreedom;
    EXPECT_LT(std::abs(perFreedom - 1), 5 * std::sqrt(2.0 / fit.joint.degreesOfFreedom)) << formula;
  }
}

TEST(OwnEffects, AreNamedWhereTheyAreKnown) {
  const OwnEffect own = effectOf("radial = A*cos(7*s) + B*sin(7*s)", {"A", "B"}, "0.2");
  const Session session = sessionWith(own, {"own:own=0.15,0.1"});
  const Measurement with = measurementOf(session, &own), without = measurementOf(session, nullptr);
  const auto known = diagnose(with), unknown = diagnose(without);
  ASSERT_TRUE(known && unknown);
  ASSERT_EQ(known->causes.size(), 1u);
  EXPECT_EQ(known->causes[0].effect, "own:own");
  EXPECT_EQ(known->verdict, DiagnosisVerdict::SingleCause);
  EXPECT_GT(known->causes[0].probability, 0.95);
  ASSERT_EQ(known->causes[0].parameters.size(), 2u);
  EXPECT_NEAR(known->causes[0].parameters[0].value, 0.15, 4 * known->causes[0].parameters[0].sigma);
  EXPECT_EQ(unknown->verdict, DiagnosisVerdict::NotInCatalogue);
  const auto leftOut = diagnose(with, {.without = {"own:own"}});
  ASSERT_TRUE(leftOut);
  for (const Cause& cause : leftOut->causes) EXPECT_NE(cause.effect, "own:own");
  const auto isOwn = [](const UncertaintyShare& share) { return share.effect == "own:own"; };
  ASSERT_TRUE(known->measured);
  EXPECT_TRUE(std::ranges::any_of(known->measured->budget, isOwn));
  EXPECT_FALSE(diagnose(without, {.without = {"own:own"}})) << "nobody knows it";
}

TEST(OwnEffects, AreInTheReviewOfAPlan) {
  const OwnEffect own = effectOf("radial = A*cos(7*s)", {"A"}, "0.2");
  const auto review = reviewPlan(measurementOf(sessionWith(own, {}), &own));
  ASSERT_TRUE(review);
  const auto found = std::ranges::find(review->effects, "own:own", &PlannedEffect::effect);
  ASSERT_NE(found, review->effects.end());
  EXPECT_GT(found->mostVisible, 10);
}

TEST(OwnEffectCheck, SaysHowFarItShows) {
  const OwnEffect own = effectOf("radial = A*cos(7*s)", {"A"}, "0.2");
  const Measurement measurement = measurementOf(sessionWith(own, {}), nullptr);
  const auto check = checkOwnEffect(measurement, own);
  ASSERT_TRUE(check);
  ASSERT_EQ(check->parameters.size(), 1u);
  EXPECT_NEAR(check->parameters[0].plausible, 0.2 * check->parameters[0].perUnit, 1e-9);
  EXPECT_GT(check->parameters[0].perUnit, 50);
  EXPECT_TRUE(check->sentences().empty());
}

TEST(OwnEffectCheck, SaysWhatIsOfNoUse) {
  const Measurement measurement = measurementOf(sessionWith(effectOf("y = A", {"A"}, "1"), {}), nullptr);
  const auto sentence = [&](const char* formula, const char* plausible) {
    const auto check = checkOwnEffect(measurement, effectOf(formula, {"A"}, plausible));
    EXPECT_TRUE(check) << formula;
    return check && check->sentences().size() == 1 ? check->sentences().front() : std::string();
  };
  EXPECT_THAT(sentence("radial = A", "0.1"), HasSubstr("0.0 σ per mm")) << "the radius is free";
  EXPECT_THAT(sentence("horizontal = A", "10"), HasSubstr("0.0 σ per arcsec"));
  EXPECT_THAT(sentence("radial = A*cos(2*s + 10°)", "0.2"), HasSubstr("“arc ellipticity”"));
  EXPECT_THAT(sentence("vertical = A*tan(e)^2", "3000"), HasSubstr("“vertical refraction”"));
  EXPECT_THAT(sentence("radial = A*sqrt(s - 90°)*cos(9*s)", "0.2"), HasSubstr("no finite value"));
}

// Compares the curves with the formulas themselves, at plausible sizes.
TEST(OwnEffectCheck, DrawsWhatTheFormulaDoes) {
  const Measurement measurement = measurementOf(sessionWith(effectOf("y = A", {"A"}, "1"), {}), nullptr);
  const auto curves = [&](const char* formula, const std::vector<std::string>& amplitudes) {
    const auto check = checkOwnEffect(measurement, effectOf(formula, amplitudes, "0.2"));
    return check ? check->curves : std::vector<OwnCurve>();
  };
  const auto bump = curves("radial = A*bump(s, 83°, 4°)", {"A"});
  ASSERT_EQ(bump.size(), 1u);
  ASSERT_TRUE(bump[0].variable);
  EXPECT_EQ(bump[0].variable->name, "s");
  ASSERT_GT(bump[0].points.size(), 100u);
  for (const auto& [s, y] : bump[0].points) EXPECT_NEAR(y, 0.2 * std::exp(-(s - 83) * (s - 83) / 32), 1e-9);
  EXPECT_LT(bump[0].points.front()[0], 83);
  EXPECT_GT(bump[0].points.back()[0], 83);

  const auto legs = curves("horizontal = A*leg; vertical = B*leg", {"A", "B"});
  ASSERT_EQ(legs.size(), 2u);
  ASSERT_TRUE(legs[1].variable);
  EXPECT_EQ(legs[1].variable->name, "leg");
  EXPECT_EQ(legs[1].points, (std::vector<std::array<double, 2>>{{-1, -0.2}, {1, 0.2}}));

  std::size_t sightings = 0;
  for (const ArcMeasurement& arc : measurement.arcs) sightings += arc.sightings.size();
  for (const OwnCurve& curve : curves("horizontal = A*leg; vertical = B*face*leg", {"A", "B"})) {
    EXPECT_FALSE(curve.variable) << "of several variables";
    EXPECT_EQ(curve.points.size(), sightings);
  }
}

TEST(KeptForm, IsAnEffectThatIsNamedFromThenOn) {
  const OwnEffect own = effectOf("radial = A*cos(7*s) + B*sin(7*s)", {"A", "B"}, "0.2");
  Session session = sessionWith(own, {"own:own=0.15,0.1"});
  session.device.serial = "G-7";
  session.title = "June";
  session.measuredOn = "2026-06-01";
  const auto unknown = diagnose(measurementOf(session, nullptr));
  ASSERT_TRUE(unknown);
  ASSERT_FALSE(unknown->forms.empty());
  const OwnEffect kept = ownEffectOf(unknown->forms[0], session);
  EXPECT_FALSE(ownEffectProblem(kept)) << ownEffectProblem(kept)->text();
  EXPECT_EQ(kept.device, "G-7");
  EXPECT_EQ(kept.from, "found in “June” of 2026-06-01");
  Session other = sessionWith(own, {"own:own=-0.1,0.12"}, 8);
  const auto named = diagnose(measurementOf(other, &kept));
  ASSERT_TRUE(named);
  ASSERT_EQ(named->causes.size(), 1u);
  EXPECT_EQ(named->causes[0].effect, ownId(kept));
}

// The formula of every function and argument of forms is accepted as a formula of an own effect.
TEST(KeptForm, HasAFormulaThatIsSound) {
  for (const char* formula :
       {"radial = A*cos(2*pi*0.530*t) + B*sin(2*pi*0.530*t)", "x = A*bump(s, 83.0°, 4.0°)",
        "y = A*step(t, 0.500)", "slider = A*max(0, s - 83.0°)/10°",
        "horizontal = face*A*exp(-t/0.200), vertical = face*B*exp(-t/0.200)", "vertical = A*(beta/10°)^2",
        "horizontal = A*(alpha/10°)", "z = A*leg", "across = A*position",
        "horizontal = A*cos(3*alpha) + B*sin(3*alpha), vertical = C*cos(3*alpha) + D*sin(3*alpha)"}) {
    FoundForm found{.form = {}, .formula = formula};
    for (const char letter : {'A', 'B', 'C', 'D'})
      if (std::string(formula).find(std::string(1, letter) + "*") != std::string::npos)
        found.coefficients.push_back({std::string(1, letter), 3.456, 0.1});
    found.form.carrier = std::string(formula).find("vertical") != std::string::npos ||
                                 std::string(formula).find("horizontal") != std::string::npos ||
                                 std::string(formula).find("slider") != std::string::npos
                             ? FormCarrier::Vertical
                             : FormCarrier::X;
    const OwnEffect kept = ownEffectOf(found, Session());
    EXPECT_FALSE(ownEffectProblem(kept)) << formula << ": " << ownEffectProblem(kept)->text();
  }
}

}  // namespace
}  // namespace alidade
