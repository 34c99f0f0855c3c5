#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/adjustment/arc/arc_fault.h"
#include "core/base/angle.h"
#include "core/base/finding.h"
#include "core/session/measurement.h"

namespace alidade {

// What a fit has to say of its data beyond its numbers, as numbers; `core/wording/findings.h` makes a
// sentence of each. Lengths in mm, rows as indices into the readings of their position.

/// Of one arc that was fitted.
namespace arc_finding {

struct NotSettled {
  int iterations = 0;
};
/// No degrees of freedom.
struct NothingChecks {};
struct ScattersMore {
  double reducedChiSquare = 1;
  int degreesOfFreedom = 1;
};
struct ScattersLess {
  double reducedChiSquare = 1;
  int degreesOfFreedom = 1;
};
struct RadiusPoorlyKnown {
  Angle span;
  double sigma = 0;
};
struct RadiusFarFromNominal {
  double fitted = 0, nominal = 0;
};
/// Rows that hold the same pair of readings: the first of them, then each other one, in its order.
struct ReadingsRepeat {
  std::vector<std::pair<std::size_t, std::size_t>> rows;
};

using What = std::variant<NotSettled, NothingChecks, ScattersMore, ScattersLess, RadiusPoorlyKnown,
                          RadiusFarFromNominal, ReadingsRepeat>;

}  // namespace arc_finding

/// Of what was typed about the set-up. `time` is everywhere the how many-th position at its axis.
namespace setup_finding {

/// No theodolite focuses so near.
struct DistanceTooShort {
  double distance = 0, nominalRadius = 0;
};
/// Most places of these arcs lie on the wrong side of their centre.
struct PlacesOnTheWrongSide {
  std::vector<int> axesDeg;
};
/// Has the pointing zero where a circle of the other kind has it.
struct ZeroOfOtherCircle {
  int axisDeg = 0;
  Angle vertical;
  VerticalCircle circle = VerticalCircle::Zenith;
  int time = 1;
};
/// In one visit; of several the most different.
struct SlidersDiffer {
  int axisDeg = 0;
  std::size_t firstRow = 0, otherRow = 0;
  Angle apart;
  std::size_t others = 0;  ///< further ones
  int time = 1;
};
/// Of all positions, and the session does not say whether they are one.
struct ZerosAlike {
  std::size_t positions = 2;
};
/// By more than two sightings of one mark, and the session does not say what they sight.
struct ZerosDiffer {
  Angle horizontal, vertical;  ///< the greatest difference from the first
};
/// Rounding alone scatters the readings of one circle more than their stated σ.
struct ReadingsRounded {
  bool isVertical = false;
  Angle step;   ///< to which the readings are written
  Angle sigma;  ///< stated
};
/// From before the readings of the position to after them, more than sightings scatter.
struct ZeroMoved {
  int axisDeg = 0, time = 1;
  Angle horizontal, vertical;            ///< as face 1 reads it
  Angle sigmaHorizontal, sigmaVertical;  ///< of these
  double scatter = 1;                    ///< by which U takes zeros to scatter more than stated
};
/// In face 2, since other positions have no zero in it.
struct ZeroFaceLeftOut {
  int axisDeg = 0, time = 1;
};

}  // namespace setup_finding

/// Of the session as a whole.
namespace session_finding {

/// The arc has no circle.
struct ArcMissing {
  int axisDeg = 0;
  ArcFault why;
  int time = 1;
};
/// Each arc is determined alone, but not all of them together.
struct Undetermined {
  bool hasEffects = false;  ///< in the model
};
struct PositionMissing {
  int axisDeg = 0;
};
struct RadiiDiffer {
  double difference = 0, bound = 0;  ///< both ≥ 0
};
/// Along the axis.
struct CentresDiffer {
  double difference = 0, bound = 0;  ///< both ≥ 0
};
struct KnownRadiusContradicted {
  double nominal = 0, pulledBy = 0, bound = 0;
};
struct OffReference {
  double reference = 0, difference = 0, expanded = 0;
};
struct UnknownEffect {
  std::string id;
};
/// What is known is of no number of the catalogue.
struct KnownOfNothing {
  std::string effect, parameter, unit;
};
/// Rows differ in what the instrument corrected, or only some tell; so nothing is known from it.
struct CorrectionsDiffer {
  std::vector<std::string> switches;  ///< their words in a row
};
/// There are tilts, but no row tells whether the instrument has taken them off.
struct TiltsUnused {};
/// From one position to another, by what the compensator read.
struct AxisMoved {
  Angle change;  ///< ≥ 0
};
/// What the compensator read in both faces is no tilt by so much.
struct CompensatorOff {
  Angle index;  ///< ≥ 0
};
/// The vertical circle is taken to read y/L.
struct PlanarRelation {};

}  // namespace session_finding

struct ArcFinding {
  int axisDeg = 0;
  arc_finding::What what;
  int time = 1;
};

struct FitFinding {
  using What = std::variant<
      ArcFinding, setup_finding::DistanceTooShort, setup_finding::PlacesOnTheWrongSide,
      setup_finding::ZeroOfOtherCircle, setup_finding::SlidersDiffer, setup_finding::ZerosAlike,
      setup_finding::ZerosDiffer, setup_finding::ReadingsRounded, setup_finding::ZeroMoved,
      setup_finding::ZeroFaceLeftOut, session_finding::ArcMissing, session_finding::Undetermined,
      session_finding::PositionMissing, session_finding::RadiiDiffer, session_finding::CentresDiffer,
      session_finding::KnownRadiusContradicted, session_finding::OffReference, session_finding::UnknownEffect,
      session_finding::KnownOfNothing, session_finding::CorrectionsDiffer, session_finding::TiltsUnused,
      session_finding::AxisMoved, session_finding::CompensatorOff, session_finding::PlanarRelation>;

  Severity severity = Severity::Warning;  ///< Error: an arc, or all of them, are not there because of this
  Place where;
  What what;
};

}  // namespace alidade
