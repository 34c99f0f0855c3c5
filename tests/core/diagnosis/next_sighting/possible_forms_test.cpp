#include "core/diagnosis/next_sighting/possible_forms.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/diagnosis/forms/form_families.h"
#include "core/effects/catalogue.h"
#include "core/guidance/sighting_choice.h"
#include "core/simulation/protocol.h"
#include "core/simulation/watched_session.h"

namespace alidade {
namespace {

TEST(PossibleForms, ShareTheWholePrior) {
  double sum = 0;
  for (const PossibleForm& possible : possibleForms()) {
    EXPECT_GT(possible.share, 0);
    sum += possible.share;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(PossibleForms, AreNoHarmonicOfTheCatalogue) {
  for (const Effect* effect : soughtEffects())
    for (const EffectParameter& parameter : effect->parameters)
      for (const auto& [form, share] : possibleForms()) {
        if (form.function != FormFunction::Harmonic) continue;
        const int order = form.carrier == FormCarrier::Radial   ? parameter.traits.radialOrder
                          : form.carrier == FormCarrier::Across ? parameter.traits.acrossOrder
                                                                : 0;
        EXPECT_NE(form.order, order) << effect->id;
      }
}

Measurement readWith(std::optional<FormHarmonic> harmonic) {
  const Protocol& protocol = *protocolByName("full");
  Truth truth = drawTruth(11);
  truth.harmonic = harmonic;
  truth.noiseFactor = 0;
  truth.placeSpread = Angle();
  truth.sigmaZero = Angle::fromArcseconds(1e-3);
  truth.typingStep = Angle::fromArcseconds(1e-4);
  WatchedSession session(protocol, truth, 3);
  for (const int axisDeg : {0, 180})
    for (int point = 1; point <= protocol.points; ++point) session.sight(axisDeg, 1, point, 1);
  return *session.measurement();
}

/// The readings of two ray-traced sessions, with and without a harmonic of the radius, differ by the columns
/// of the harmonic. 0.02 mm move a reading by 1 σ; the tolerance is a hundredth of σ.
TEST(PossibleForms, ChangeTheReadingsAsTheSimulatorDoes) {
  constexpr double cosine = 0.02, sine = -0.015;  // mm
  const Measurement without = readWith({}),
                    with = readWith(FormHarmonic{.order = 5, .cosine = cosine, .sine = sine});
  const SightingPlan plan = openPlan(templateOf(*protocolByName("full")));
  PossibleSightings session = possibleSightings(without, plan);
  const std::vector<Circle> circles(session.measurement.arcs.size(), {0, 0, without.nominalRadius});
  sightPossible(session, plan, circles);
  Linearised all;
  linearise(session.measurement, circles, {.isClosed = true}, everyTerm(),
            [&](const Linearised& piece) { all = piece; });
  const std::vector<Eigen::MatrixXd> forms = columnsOfForms(session, circles, all);
  const auto isHarmonic = [](const PossibleForm& possible) {
    return possible.form.carrier == FormCarrier::Radial && possible.form.order == 5;
  };
  const auto index = std::ranges::find_if(possibleForms(), isHarmonic) - possibleForms().begin();
  const Eigen::MatrixXd& harmonic = forms[static_cast<std::size_t>(index)];
  const double unit = formUnit(FormCarrier::Radial);
  int compared = 0;
  for (std::size_t i = 0; i < all.readings.size(); ++i) {
    const LinearReading& reading = all.readings[i];
    if (reading.isZero || reading.arc > 1 || reading.sighting >= without.arcs[reading.arc].sightings.size() ||
        reading.kind == ReadingKind::Slider)
      continue;
    const Sighting &before = without.arcs[reading.arc].sightings[reading.sighting],
                   &after = with.arcs[reading.arc].sightings[reading.sighting];
    const Angle change = reading.kind == ReadingKind::Horizontal ? after.a - before.a : after.e - before.e;
    const auto columns = harmonic.row(static_cast<Eigen::Index>(i));
    EXPECT_NEAR(columns[0] * cosine / unit + columns[1] * sine / unit, change.radians() / reading.sigma,
                0.02);
    ++compared;
  }
  EXPECT_GE(compared, 60);
}

}  // namespace
}  // namespace alidade
