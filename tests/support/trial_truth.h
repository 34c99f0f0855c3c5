#pragma once

#include <cmath>
#include <numbers>

#include "core/simulation/truth.h"
#include "tests/support/trials.h"

namespace alidade::test {

/// The truth of a ray-traced session in this program's names, units and signs.
inline Truth truthOf(const Trial& trial) {
  using enum ErrorTerm;
  Truth truth;
  const nlohmann::json& effects = trial.effects;
  const auto put = [&](ErrorTerm term, const char* name, double factor = 1) {
    if (effects.contains(name)) truth.effects.push_back({term, factor * effects[name].get<double>()});
  };
  put(Collimation, "collimation", -1);  // the ray tracer has the opposite sign
  put(TrunnionTilt, "trunnion");
  put(VerticalIndex, "index");
  put(VerticalAxisTiltX, "axis_tilt_x");
  put(VerticalAxisTiltZ, "axis_tilt_z");
  put(HorizontalDrift, "drift_h");
  put(VerticalDrift, "drift_v");
  put(PlaneTiltX, "plane_tilt_x");
  put(PlaneTiltY, "plane_tilt_y");
  put(PlaneOffset, "plane_offset");
  put(AxialShift, "axial_shift");
  put(RadiusChange, "radius_change");
  put(EllipticityCosine, "ellip_c");
  put(EllipticitySine, "ellip_s");
  put(LobingCosine, "lobe3_c");
  put(LobingSine, "lobe3_s");
  put(GravitySag, "sag");
  put(WarpCosine, "warp_c");
  put(WarpSine, "warp_s");
  put(SliderScale, "slider_scale");
  put(SliderSine, "slider_ecc");
  if (effects.contains("planar")) truth.effects.push_back({VerticalAngleRelation, 1});

  // ε sin(reading − phase), the phase in degrees.
  const auto putCircle = [&](ErrorTerm sine, ErrorTerm cosine, double amplitude, double phase) {
    truth.effects.push_back({sine, amplitude * std::cos(phase * std::numbers::pi / 180)});
    truth.effects.push_back({cosine, -amplitude * std::sin(phase * std::numbers::pi / 180)});
  };
  if (effects.contains("hcirc_amp"))
    putCircle(HorizontalCircleSine, HorizontalCircleCosine, effects["hcirc_amp"], effects["hcirc_phase"]);
  if (effects.contains("vcirc_amp"))
    putCircle(VerticalCircleSine, VerticalCircleCosine, effects["vcirc_amp"], effects["vcirc_phase"]);
  if (effects.contains("jump"))
    truth.jump = {effects["jump"][0], Angle::fromArcseconds(effects["jump"][1]),
                  Angle::fromArcseconds(effects["jump"][2])};
  if (effects.contains("zero_slip"))
    truth.wrongZero = {effects["zero_slip"][0] == 0 ? 0 : 180, Angle::fromArcseconds(effects["zero_slip"][1]),
                       Angle::fromArcseconds(effects["zero_slip"][2])};
  if (effects.contains("harmonic"))
    truth.harmonic = {effects["harmonic"][0], effects["harmonic"][1], effects["harmonic"][2]};

  truth.distance = trial.measurement.distance;
  truth.intersection = trial.intersection;
  truth.radius = trial.truth.at("radius_mm");
  truth.centreX = trial.truth.at("centre_x_mm");
  truth.axisHeight = trial.truth.at("axis_height_mm");
  truth.noiseFactor = trial.truth.value("true_sigma_arcsec", 2.0) / 2.0;
  for (const auto& grossError : trial.truth.at("blunders"))
    truth.grossErrors.push_back({grossError[0] == 0 ? 0 : 180, grossError[1], grossError[2], grossError[3],
                                 Angle::fromArcseconds(grossError[4]), Angle::fromArcseconds(grossError[5])});
  return truth;
}

}  // namespace alidade::test
