#include "core/effects/catalogue.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/base/angle.h"
#include "core/base/phrase.h"
#include "core/effects/cause_ids.h"
#include "core/session/measurement.h"

namespace alidade {

namespace {

constexpr std::vector<Effect> makeCatalogue() {
  using enum ErrorTerm;
  using enum Response;
  return {
      {relationId,
       PHRASE_LATER("Phrase", "vertical angle relation"),
       PHRASE_LATER("Phrase",
                    "the vertical circle follows the other relation between height and angle (y/L instead of "
                    "y/√(x²+L²), or the reverse)"),
       PHRASE_LATER("Phrase", "correct the session's vertical angle relation"),
       ErrorSource::Instrument,
       AllOrNothing,
       //: how much of the effect is there
       {{PHRASE_LATER("Phrase", "share"), VerticalAngleRelation, "-", 1}}},
      {"collimation",
       PHRASE_LATER("Phrase", "collimation"),
       PHRASE_LATER("Phrase", "the line of sight is not perpendicular to the trunnion axis"),
       PHRASE_LATER("Phrase", "observe in both faces, or adjust the reticle"),
       ErrorSource::Instrument,
       Linear,
       {{PHRASE_LATER("Phrase", "collimation"), Collimation, "arcsec", 30}}},
      {"trunnion_tilt",
       PHRASE_LATER("Phrase", "trunnion tilt"),
       PHRASE_LATER("Phrase", "the trunnion axis is not perpendicular to the vertical axis"),
       PHRASE_LATER("Phrase", "observe in both faces"),
       ErrorSource::Instrument,
       Linear,
       //: the size of a tilt
       {{PHRASE_LATER("Phrase", "tilt"), TrunnionTilt, "arcsec", 30}}},
      {"vertical_index",
       PHRASE_LATER("Phrase", "vertical index"),
       PHRASE_LATER("Phrase", "the vertical circle has an index error"),
       PHRASE_LATER("Phrase", "observe in both faces"),
       ErrorSource::Instrument,
       Linear,
       //: the error of a circle's index
       {{PHRASE_LATER("Phrase", "index"), VerticalIndex, "arcsec", 30}}},
      {"vertical_axis_tilt",
       PHRASE_LATER("Phrase", "vertical axis tilt"),
       PHRASE_LATER("Phrase", "the vertical axis is not plumb"),
       PHRASE_LATER("Phrase", "level the instrument, or switch its compensator on"),
       ErrorSource::Instrument,
       Linear,
       {{PHRASE_LATER("Phrase", "tilt about x"), VerticalAxisTiltX, "arcsec", 60},
        {PHRASE_LATER("Phrase", "tilt about z"), VerticalAxisTiltZ, "arcsec", 60}}},
      {"horizontal_circle_eccentricity",
       PHRASE_LATER("Phrase", "horizontal circle eccentricity"),
       PHRASE_LATER("Phrase", "the horizontal circle is not centred on its axis"),
       PHRASE_LATER("Phrase", "observe in both faces, or repeat with a shifted circle"),
       ErrorSource::Instrument,
       Linear,
       //: the part of a wave that goes as the sine
       {{PHRASE_LATER("Phrase", "sine"), HorizontalCircleSine, "arcsec", 10},
        //: the part of a wave that goes as the cosine
        {PHRASE_LATER("Phrase", "cosine"), HorizontalCircleCosine, "arcsec", 10}}},
      {"vertical_circle_eccentricity",
       PHRASE_LATER("Phrase", "vertical circle eccentricity"),
       PHRASE_LATER("Phrase", "the vertical circle is not centred on its axis"),
       PHRASE_LATER("Phrase", "observe in both faces"),
       ErrorSource::Instrument,
       Linear,
       {{PHRASE_LATER("Phrase", "sine"), VerticalCircleSine, "arcsec", 10},
        {PHRASE_LATER("Phrase", "cosine"), VerticalCircleCosine, "arcsec", 10}}},
      // The second harmonic of a circle, which remains in the mean of two opposite readings. At the horizon
      // its cosine acts like an index.
      {"vertical_graduation",
       PHRASE_LATER("Phrase", "vertical graduation"),
       PHRASE_LATER("Phrase", "the vertical circle's graduation error has two periods per turn"),
       PHRASE_LATER("Phrase", "observe in both faces, and have the circle calibrated"),
       ErrorSource::Instrument,
       Linear,
       {{PHRASE_LATER("Phrase", "sine"), VerticalGraduationSine, "arcsec", 0.7},
        {PHRASE_LATER("Phrase", "cosine"), VerticalGraduationCosine, "arcsec", 0.7}}},
      // Refraction that is equal above and below the horizon; its constant part is in the zero. A gradient of
      // 2 K/m bends a line of 2.4 m by half an arcsecond: δ = 0.93e-6/K · 2 K/m · L/2.
      {"vertical_refraction",
       PHRASE_LATER("Phrase", "vertical refraction"),
       PHRASE_LATER("Phrase",
                    "layers of warm air bend the lines of sight, in proportion to the square of the "
                    "elevation (size at 10°)"),
       PHRASE_LATER("Phrase", "keep sources of heat away, and stir the air"),
       ErrorSource::Instrument,
       Linear,
       //: how far a line of sight is bent
       {{PHRASE_LATER("Phrase", "bend"), VerticalRefraction, "arcsec", 0.5}}},
      {"horizontal_drift",
       PHRASE_LATER("Phrase", "horizontal drift"),
       PHRASE_LATER("Phrase", "the horizontal orientation turns steadily during the session"),
       PHRASE_LATER("Phrase", "observe there and back, and let the instrument settle"),
       ErrorSource::Time,
       Linear,
       //: how far something drifts
       {{PHRASE_LATER("Phrase", "drift"), HorizontalDrift, "arcsec", 15, {.turnsHorizontalZero = true}}}},
      {"vertical_drift",
       PHRASE_LATER("Phrase", "vertical drift"),
       PHRASE_LATER("Phrase", "the vertical orientation turns steadily during the session"),
       PHRASE_LATER("Phrase", "observe there and back, and let the instrument settle"),
       ErrorSource::Time,
       Linear,
       {{PHRASE_LATER("Phrase", "drift"), VerticalDrift, "arcsec", 15, {.turnsVerticalZero = true}}}},
      {"plane_tilt",
       PHRASE_LATER("Phrase", "plane tilt"),
       PHRASE_LATER("Phrase", "the arc plane is not perpendicular to the zero direction"),
       PHRASE_LATER("Phrase", "read the slider, and determine the pointing zero again"),
       ErrorSource::Guideway,
       Bent,
       {{PHRASE_LATER("Phrase", "tilt about x"), PlaneTiltX, "deg", 0.3},
        {PHRASE_LATER("Phrase", "tilt about y"), PlaneTiltY, "deg", 0.3}}},
      {"plane_offset",
       PHRASE_LATER("Phrase", "plane offset"),
       PHRASE_LATER(
           "Phrase",
           "the arc plane is offset from the rotation axis, so the distance differs between the positions"),
       PHRASE_LATER("Phrase", "measure the distance in both positions"),
       ErrorSource::Guideway,
       Linear,
       //: how far something lies off
       {{PHRASE_LATER("Phrase", "offset"), PlaneOffset, "mm", 1, {.changesDistance = true}}}},
      {"plane_skew",
       PHRASE_LATER("Phrase", "plane skew"),
       PHRASE_LATER("Phrase",
                    "the arc plane is askew to the rotation axis, and turns over with the guideway"),
       PHRASE_LATER("Phrase", "read the slider, and square the guideway to its axis"),
       ErrorSource::Guideway,
       Linear,
       //: how far something is askew
       {{PHRASE_LATER("Phrase", "skew"), PlaneSkew, "deg", 0.1, {.acrossOrder = 1}}}},
      {"axial_shift",
       PHRASE_LATER("Phrase", "axial shift"),
       PHRASE_LATER("Phrase", "the guideway moves along its axis when it is turned"),
       PHRASE_LATER("Phrase", "sight the zero again before and after turning, and check the axial bearing"),
       ErrorSource::Guideway,
       Linear,
       //: how far something shifts
       {{PHRASE_LATER("Phrase", "shift"), AxialShift, "mm", 0.2}}},
      {"radius_change",
       PHRASE_LATER("Phrase", "radius change"),
       PHRASE_LATER("Phrase", "the radius differs between the positions"),
       PHRASE_LATER("Phrase", "measure the distance in both positions, and check play and temperature"),
       ErrorSource::Guideway,
       Linear,
       //: how much something changes
       {{PHRASE_LATER("Phrase", "change"), RadiusChange, "mm", 0.1}}},
      {"arc_ellipticity",
       PHRASE_LATER("Phrase", "arc ellipticity"),
       PHRASE_LATER("Phrase", "the guideway is elliptic"),
       PHRASE_LATER("Phrase", "read the slider to map the form of the guideway"),
       ErrorSource::Guideway,
       Linear,
       {{PHRASE_LATER("Phrase", "cosine"), EllipticityCosine, "mm", 0.05, {.radialOrder = 2}},
        {PHRASE_LATER("Phrase", "sine"), EllipticitySine, "mm", 0.05, {.radialOrder = 2}}}},
      {"arc_lobing",
       PHRASE_LATER("Phrase", "arc lobing"),
       PHRASE_LATER("Phrase", "the guideway has three lobes"),
       PHRASE_LATER("Phrase", "read the slider to map the form of the guideway"),
       ErrorSource::Guideway,
       Linear,
       {{PHRASE_LATER("Phrase", "cosine"), LobingCosine, "mm", 0.05, {.radialOrder = 3}},
        {PHRASE_LATER("Phrase", "sine"), LobingSine, "mm", 0.05, {.radialOrder = 3}}}},
      {"gravity_sag",
       PHRASE_LATER("Phrase", "gravity sag"),
       PHRASE_LATER("Phrase", "the slider sags under its weight, whichever way the guideway is turned"),
       PHRASE_LATER("Phrase", "read the slider, and stiffen the guideway"),
       ErrorSource::Guideway,
       Linear,
       //: how far something sags
       {{PHRASE_LATER("Phrase", "sag"), GravitySag, "mm", 0.05}}},
      // A weight at the end of a radial arm bends the arm in proportion to its horizontal part, cos φ. The
      // end moves perpendicular to the arm, along the arc.
      {"arm_sag",
       PHRASE_LATER("Phrase", "arm sag"),
       PHRASE_LATER("Phrase", "the slider's arm bends under its weight, most where it is horizontal"),
       PHRASE_LATER("Phrase", "read the slider, and stiffen its arm"),
       ErrorSource::Guideway,
       Linear,
       {{PHRASE_LATER("Phrase", "sag"), ArmSag, "mm", 0.05}}},
      {"plane_warp",
       PHRASE_LATER("Phrase", "plane warp"),
       PHRASE_LATER("Phrase", "the guideway is warped out of its plane"),
       PHRASE_LATER("Phrase", "observe from a second stand-off"),
       ErrorSource::Guideway,
       Linear,
       {{PHRASE_LATER("Phrase", "cosine"), WarpCosine, "mm", 0.2, {.acrossOrder = 2}},
        {PHRASE_LATER("Phrase", "sine"), WarpSine, "mm", 0.2, {.acrossOrder = 2}}}},
      {"slider_scale",
       PHRASE_LATER("Phrase", "slider scale"),
       PHRASE_LATER("Phrase", "the slider's scale is stretched"),
       PHRASE_LATER("Phrase", "calibrate the slider"),
       ErrorSource::Guideway,
       Linear,
       //: how much a scale is stretched
       {{PHRASE_LATER("Phrase", "scale"), SliderScale, "1", 5e-4, {.needsSlider = true}}}},
      {"slider_eccentricity",
       PHRASE_LATER("Phrase", "slider eccentricity"),
       PHRASE_LATER("Phrase", "the slider's scale is not centred on the arc"),
       PHRASE_LATER("Phrase", "calibrate the slider"),
       ErrorSource::Guideway,
       Linear,
       {{PHRASE_LATER("Phrase", "sine"), SliderSine, "arcsec", 60, {.needsSlider = true}}}},
      {"setup_shift",
       PHRASE_LATER("Phrase", "setup shift"),
       PHRASE_LATER("Phrase",
                    "the instrument or the axis is displaced between the first position and the later ones"),
       PHRASE_LATER(
           "Phrase",
           "fasten instrument and device to one foundation, and measure the first position again at the end"),
       ErrorSource::Time,
       Linear,
       {{PHRASE_LATER("Phrase", "shift along x"), SetupShiftX, "mm", 0.05},
        {PHRASE_LATER("Phrase", "shift along y"), SetupShiftY, "mm", 0.05}},
       false},
  };
}

/// Each error term belongs to exactly one effect, except the terms of a jump and the user's own terms.
constexpr bool sharesOutTheTerms(const std::vector<Effect>& effects) {
  std::array<int, errorTermCount> times{};
  for (const Effect& effect : effects)
    for (const EffectParameter& parameter : effect.parameters)
      ++times[static_cast<std::size_t>(parameter.term)];
  for (std::size_t i = 0; i < errorTermCount; ++i)
    if (const auto term = static_cast<ErrorTerm>(i); times[i] != (isOfJump(term) || isOwn(term) ? 0 : 1))
      return false;
  return true;
}

constexpr bool isOfItsSource(const Effect& effect) {
  for (const EffectParameter& parameter : effect.parameters)
    if (isOfGuideway(parameter.term) != (effect.source == ErrorSource::Guideway)) return false;
  return true;
}

constexpr bool canRespondSo(const Effect& effect) {
  switch (effect.response) {
    case Response::Linear:
      return !effect.parameters.empty();
    case Response::Bent:
      return effect.parameters.size() == 2 && effect.source == ErrorSource::Guideway;
    case Response::AllOrNothing:
      return effect.parameters.size() == 1;
  }
  return false;
}

static_assert(sharesOutTheTerms(makeCatalogue()),
              "every error term except those of the jump must belong to one effect");
static_assert(std::ranges::all_of(makeCatalogue(), isOfItsSource),
              "the source of an effect is the guideway exactly if that of its error terms is");
static_assert(std::ranges::all_of(makeCatalogue(), canRespondSo),
              "a bent response needs two parameters of the guideway, an all-or-nothing response needs one");

const std::vector<Effect>& catalogue() {
  static const std::vector<Effect> effects = makeCatalogue();
  return effects;
}

}  // namespace

std::span<const Effect> effectCatalogue() {
  return catalogue();
}

std::vector<const Effect*> soughtEffects() {
  std::vector<const Effect*> sought;
  for (const Effect& effect : catalogue())
    if (effect.isSought) sought.push_back(&effect);
  return sought;
}

const Effect* effectById(std::string_view id) {
  const auto found = std::ranges::find(catalogue(), id, &Effect::id);
  return found == catalogue().end() ? nullptr : &*found;
}

const Effect* effectOf(ErrorTerm term) {
  const auto found = std::ranges::find_if(catalogue(), [&](const Effect& effect) {
    return std::ranges::find(effect.parameters, term, &EffectParameter::term) != effect.parameters.end();
  });
  return found == catalogue().end() ? nullptr : &*found;
}

std::vector<const Effect*> effectsWith(const OwnEffects* own) {
  std::vector<const Effect*> all;
  for (const Effect& effect : catalogue()) all.push_back(&effect);
  if (own)
    for (const OwnEntry& entry : own->entries()) all.push_back(&entry.effect);
  return all;
}

std::vector<const Effect*> effectsOf(const Measurement& measurement) {
  return effectsWith(measurement.own.get());
}

const Effect* effectById(std::string_view id, const Measurement& measurement) {
  const Effect* effect = effectById(id);
  return !effect && measurement.own ? measurement.own->find(id) : effect;
}

const Effect* effectOf(ErrorTerm term, const Measurement& measurement) {
  if (!isOwn(term)) return effectOf(term);
  return measurement.own ? measurement.own->find(term) : nullptr;
}

bool needsSlider(const Effect& effect) {
  return std::ranges::any_of(effect.parameters,
                             [](const EffectParameter& parameter) { return parameter.traits.needsSlider; });
}

double modelUnitsPer(std::string_view unit) {
  if (unit == "arcsec") return Angle::fromArcseconds(1).radians();
  if (unit == "deg") return Angle::fromDegrees(1).radians();
  assert(unit == "mm" || unit == "1" || unit == "-");
  return 1;
}

std::string parameterName(std::string_view name) {
  return Phrase::of(std::string(name).c_str());
}

double plausibleSize(const EffectParameter& parameter) {
  return parameter.plausible * modelUnitsPer(parameter.unit);
}

}  // namespace alidade
