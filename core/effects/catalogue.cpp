#include "core/effects/catalogue.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/base/angle.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

constexpr std::vector<Effect> makeCatalogue() {
  using enum ErrorTerm;
  using enum Response;
  return {
      {relationId,
       "the vertical circle follows the other relation between height and angle (y/L instead of y/√(x²+L²), "
       "or the reverse)",
       "set the session's vertical angle relation right",
       ErrorSource::Instrument,
       AllOrNothing,
       {{"share", VerticalAngleRelation, "-", 1}}},
      {"collimation",
       "the line of sight is not perpendicular to the trunnion axis",
       "observe in both faces, or adjust the reticle",
       ErrorSource::Instrument,
       Linear,
       {{"collimation", Collimation, "arcsec", 30}}},
      {"trunnion_tilt",
       "the trunnion axis is not perpendicular to the vertical axis",
       "observe in both faces",
       ErrorSource::Instrument,
       Linear,
       {{"tilt", TrunnionTilt, "arcsec", 30}}},
      {"vertical_index",
       "the vertical circle's index is off",
       "observe in both faces",
       ErrorSource::Instrument,
       Linear,
       {{"index", VerticalIndex, "arcsec", 30}}},
      {"vertical_axis_tilt",
       "the vertical axis is not plumb",
       "level the instrument, or switch its compensator on",
       ErrorSource::Instrument,
       Linear,
       {{"tilt about x", VerticalAxisTiltX, "arcsec", 60},
        {"tilt about z", VerticalAxisTiltZ, "arcsec", 60}}},
      {"horizontal_circle_eccentricity",
       "the horizontal circle is not centred on its axis",
       "observe in both faces, or repeat with a shifted circle",
       ErrorSource::Instrument,
       Linear,
       {{"sine", HorizontalCircleSine, "arcsec", 10}, {"cosine", HorizontalCircleCosine, "arcsec", 10}}},
      {"vertical_circle_eccentricity",
       "the vertical circle is not centred on its axis",
       "observe in both faces",
       ErrorSource::Instrument,
       Linear,
       {{"sine", VerticalCircleSine, "arcsec", 10}, {"cosine", VerticalCircleCosine, "arcsec", 10}}},
      {"horizontal_drift",
       "the horizontal orientation turns steadily during the session",
       "observe there and back, and let the instrument settle",
       ErrorSource::Time,
       Linear,
       {{"drift", HorizontalDrift, "arcsec", 15}}},
      {"vertical_drift",
       "the vertical orientation turns steadily during the session",
       "observe there and back, and let the instrument settle",
       ErrorSource::Time,
       Linear,
       {{"drift", VerticalDrift, "arcsec", 15}}},
      {"plane_tilt",
       "the arc plane is not perpendicular to the zero direction",
       "read the slider, and determine the pointing zero anew",
       ErrorSource::Guideway,
       Bent,
       {{"tilt about x", PlaneTiltX, "deg", 0.3}, {"tilt about y", PlaneTiltY, "deg", 0.3}}},
      {"plane_offset",
       "the arc plane lies off the rotation axis, so the distance differs between the positions",
       "measure the distance in both positions",
       ErrorSource::Guideway,
       Linear,
       {{"offset", PlaneOffset, "mm", 1}}},
      {"axial_shift",
       "the guideway moves along its axis when it is turned",
       "sight the zero again before and after turning, and look at the axial bearing",
       ErrorSource::Guideway,
       Linear,
       {{"shift", AxialShift, "mm", 0.2}}},
      {"radius_change",
       "the radius differs between the positions",
       "measure the distance in both positions, and look for play and temperature",
       ErrorSource::Guideway,
       Linear,
       {{"change", RadiusChange, "mm", 0.1}}},
      {"arc_ellipticity",
       "the guideway is elliptic",
       "read the slider to map its form",
       ErrorSource::Guideway,
       Linear,
       {{"cosine", EllipticityCosine, "mm", 0.05}, {"sine", EllipticitySine, "mm", 0.05}}},
      {"arc_lobing",
       "the guideway has three lobes",
       "read the slider to map its form",
       ErrorSource::Guideway,
       Linear,
       {{"cosine", LobingCosine, "mm", 0.05}, {"sine", LobingSine, "mm", 0.05}}},
      {"gravity_sag",
       "the slider sags under its weight, whichever way the guideway is turned",
       "read the slider, and stiffen the guideway",
       ErrorSource::Guideway,
       Linear,
       {{"sag", GravitySag, "mm", 0.05}}},
      {"plane_warp",
       "the guideway is warped out of its plane",
       "observe from a second stand-off",
       ErrorSource::Guideway,
       Linear,
       {{"cosine", WarpCosine, "mm", 0.2}, {"sine", WarpSine, "mm", 0.2}}},
      {"slider_scale",
       "the slider's scale is stretched",
       "calibrate the slider",
       ErrorSource::Guideway,
       Linear,
       {{"scale", SliderScale, "1", 5e-4}}},
      {"slider_eccentricity",
       "the slider's scale is not centred on the arc",
       "calibrate the slider",
       ErrorSource::Guideway,
       Linear,
       {{"sine", SliderSine, "arcsec", 60}}},
      {"setup_shift",
       "instrument or axis is displaced between the first position and those after it",
       "fasten instrument and machine to one foundation, and measure the first position again at the end",
       ErrorSource::Time,
       Linear,
       {{"shift along x", SetupShiftX, "mm", 0.05}, {"shift along y", SetupShiftY, "mm", 0.05}},
       false},
  };
}

/// Each error term but the jump's is a number of one effect.
constexpr bool sharesOutTheTerms(const std::vector<Effect>& effects) {
  std::array<int, errorTermCount> times{};
  for (const Effect& effect : effects)
    for (const EffectParameter& parameter : effect.parameters)
      ++times[static_cast<std::size_t>(parameter.term)];
  for (std::size_t term = 0; term < errorTermCount; ++term)
    if (times[term] != (isOfJump(static_cast<ErrorTerm>(term)) ? 0 : 1)) return false;
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

static_assert(sharesOutTheTerms(makeCatalogue()), "every error term but the jump's belongs to one effect");
static_assert(std::ranges::all_of(makeCatalogue(), isOfItsSource),
              "an effect is the guideway's where its terms are");
static_assert(std::ranges::all_of(makeCatalogue(), canRespondSo),
              "what bends has two numbers of the guideway, what is all or nothing has one");

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

double modelUnitsPer(std::string_view unit) {
  if (unit == "arcsec") return Angle::fromArcseconds(1).radians();
  if (unit == "deg") return Angle::fromDegrees(1).radians();
  assert(unit == "mm" || unit == "1" || unit == "-");
  return 1;
}

double plausibleSize(const EffectParameter& parameter) {
  return parameter.plausible * modelUnitsPer(parameter.unit);
}

}  // namespace alidade
