#pragma once

#include <span>
#include <string_view>

#include "core/base/angle.h"

namespace alidade {

/// An uncatalogued disturbance, unknown to every fit, which the diagnosis must leave unexplained.
struct ForeignEffect {
  enum class Kind {
    LocalDent,  ///< radius + size·exp(−½((s − first)/second)²): size mm, place and width in degrees of s
    CirclePeriods,  ///< δα = size·sin(first·α + second): size arcsec, periods a turn, phase in degrees
    Settling,       ///< adds size·exp(−t/first), arcsec, to azimuth and elevation; t: elapsed share, 0…1
    DistanceRamp,   ///< the distance grows by size, mm, over the session
    Refraction,     ///< δe = size·sin 2e, arcsec, of opposite sign below the horizon
    Backlash,       ///< on the way back (even rounds) the horizontal circle reads size, arcsec, more
    HighWarp,       ///< off the plane by size·sin(first·s + second), mm, turning with the guideway
  };

  Kind kind = Kind::LocalDent;
  double size = 0, first = 0, second = 0;
};

/// The name of the disturbance on the command line and in truth files, and the numbers that it takes.
struct ForeignEffectName {
  ForeignEffect::Kind kind;
  std::string_view name;
  std::string_view usage;
  int numbers;  ///< 1 to 3
};

std::span<const ForeignEffectName> foreignEffectNames();
std::string_view nameOf(ForeignEffect::Kind kind);

/// Change of the radius with the slider at `s`, mm.
double radiusBy(const ForeignEffect& effect, Angle s);
/// Offset of the target from the plane in the guideway's own frame with the slider at `s`, mm.
double offPlaneBy(const ForeignEffect& effect, Angle s);
/// Change of the distance at the elapsed share `elapsed` of the session, mm.
double distanceBy(const ForeignEffect& effect, double elapsed);
/// Change of the azimuth, face 1 equivalent; `circle` is the horizontal reading of the face.
Angle azimuthBy(const ForeignEffect& effect, Angle circle, double elapsed, bool wayBack);
/// Change of the elevation, face 1 equivalent.
Angle elevationBy(const ForeignEffect& effect, Angle elevation, double elapsed);

}  // namespace alidade
