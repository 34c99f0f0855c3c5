#include "core/simulation/foreign_effect.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alidade {

namespace {

using Kind = ForeignEffect::Kind;

constexpr std::array effectNames = {
    ForeignEffectName{Kind::LocalDent, "local_dent", "depth (mm), place and width (deg)", 3},
    ForeignEffectName{Kind::CirclePeriods, "circle_periods", "size (arcsec), periods a turn, phase (deg)", 3},
    ForeignEffectName{Kind::Settling, "settling", "size (arcsec), time constant (share of the session)", 2},
    ForeignEffectName{Kind::DistanceRamp, "distance_ramp", "growth over the session (mm)", 1},
    ForeignEffectName{Kind::Refraction, "refraction", "size (arcsec)", 1},
    ForeignEffectName{Kind::Backlash, "backlash", "size (arcsec)", 1},
    ForeignEffectName{Kind::HighWarp, "high_warp", "size (mm), waves a turn, phase (deg)", 3},
};

double wave(const ForeignEffect& effect, Angle at) {
  return effect.size * std::sin(effect.first * at.radians() + Angle::fromDegrees(effect.second).radians());
}

}  // namespace

std::span<const ForeignEffectName> foreignEffectNames() {
  return effectNames;
}

std::string_view nameOf(Kind kind) {
  return std::ranges::find(effectNames, kind, &ForeignEffectName::kind)->name;
}

double radiusBy(const ForeignEffect& effect, Angle s) {
  if (effect.kind != Kind::LocalDent) return 0;
  return effect.size * std::exp(-0.5 * std::pow((s.degrees() - effect.first) / effect.second, 2));
}

double offPlaneBy(const ForeignEffect& effect, Angle s) {
  return effect.kind == Kind::HighWarp ? wave(effect, s) : 0;
}

double distanceBy(const ForeignEffect& effect, double elapsed) {
  return effect.kind == Kind::DistanceRamp ? effect.size * elapsed : 0;
}

Angle azimuthBy(const ForeignEffect& effect, Angle circle, double elapsed, bool wayBack) {
  switch (effect.kind) {
    case Kind::CirclePeriods:
      return Angle::fromArcseconds(wave(effect, circle));
    case Kind::Settling:
      return Angle::fromArcseconds(effect.size * std::exp(-elapsed / effect.first));
    case Kind::Backlash:
      return wayBack ? Angle::fromArcseconds(effect.size) : Angle();
    default:
      return {};
  }
}

Angle elevationBy(const ForeignEffect& effect, Angle elevation, double elapsed) {
  switch (effect.kind) {
    case Kind::Settling:
      return Angle::fromArcseconds(effect.size * std::exp(-elapsed / effect.first));
    case Kind::Refraction:
      return Angle::fromArcseconds(effect.size * std::sin(2 * elevation.radians()));
    default:
      return {};
  }
}

}  // namespace alidade
