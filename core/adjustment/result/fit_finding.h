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

// Findings of a fit on its data, as numbers; `core/wording/findings.h` makes a sentence of each. Lengths in
// mm, rows as indices into the readings of their position.

/// Findings on one fitted arc.
namespace arc_finding {

struct NotConverged {
  int iterations = 0;
};
/// The fit has no redundancy.
struct NothingChecks {};
struct ScattersMore {
  double reducedChiSquare = 1;
  double degreesOfFreedom = 1;
};
struct ScattersLess {
  double reducedChiSquare = 1;
  double degreesOfFreedom = 1;
};
struct RadiusPoorlyKnown {
  Angle span;
  double sigma = 0;
};
struct RadiusFarFromNominal {
  double fitted = 0, nominal = 0;
};
/// Pairs of rows with the same two circle readings: the first row of a group and a further row, in order.
struct ReadingsRepeat {
  std::vector<std::pair<std::size_t, std::size_t>> rows;
};

using What = std::variant<NotConverged, NothingChecks, ScattersMore, ScattersLess, RadiusPoorlyKnown,
                          RadiusFarFromNominal, ReadingsRepeat>;

}  // namespace arc_finding

/// Findings on the typed set-up data. `repeat` is always the repeat at the position's axis.
namespace setup_finding {

/// No theodolite focuses at this distance.
struct DistanceTooShort {
  double distance = 0, nominalRadius = 0;
};
/// Most places of these arcs are below their centre at 0°, or above it at 180°.
struct PlacesOnTheWrongSide {
  std::vector<int> axesDeg;
};
/// The pointing zero fits a vertical circle of the other kind.
struct ZeroOfOtherCircle {
  int axisDeg = 0;
  Angle vertical;
  VerticalCircle circle = VerticalCircle::Zenith;
  int repeat = 1;
};
/// Slider values of one visit differ; the largest of several differences.
struct SlidersDiffer {
  int axisDeg = 0;
  std::size_t firstRow = 0, otherRow = 0;
  Angle apart;
  std::size_t others = 0;  ///< further differences
  int repeat = 1;
};
/// The zeros of all positions are identical; the session does not state whether they are one mark.
struct ZerosAlike {
  std::size_t positions = 2;
};
/// The zeros differ by more than sightings of one mark do; the session does not state what was sighted.
struct ZerosDiffer {
  Angle horizontal, vertical;  ///< the greatest difference from the first
};
/// Rounding alone scatters the readings of one circle more than their stated σ.
struct ReadingsRounded {
  bool isVertical = false;
  Angle step;   ///< to which the readings are rounded
  Angle sigma;  ///< stated
};
/// The zeros before and after the readings of the position differ by more than sightings scatter. If
/// `isOfOneFace`, the change is what face 2 changed more than face 1.
struct ZeroMoved {
  int axisDeg = 0, repeat = 1;
  Angle horizontal, vertical;            ///< change of the zero, as read in face 1
  Angle sigmaHorizontal, sigmaVertical;  ///< of this change
  double scatter = 1;                    ///< factor by which U assumes zeros to scatter more than stated
  bool isOfOneFace = false;              ///< one of the sightings may be misread
};
/// The zero in face 2 is ignored, since other positions have none.
struct ZeroFaceLeftOut {
  int axisDeg = 0, repeat = 1;
};

}  // namespace setup_finding

/// Findings on the session as a whole.
namespace session_finding {

/// The arc has no circle.
struct ArcMissing {
  int axisDeg = 0;
  ArcFault why;
  int repeat = 1;
};
/// Each arc is determined alone, but all of them together are not.
struct Undetermined {
  bool hasEffects = false;  ///< in the model
};
struct PositionMissing {
  int axisDeg = 0;
};
struct RadiiDiffer {
  double difference = 0, bound = 0;  ///< both ≥ 0
};
/// The centres differ along the axis.
struct CentresDiffer {
  double difference = 0, bound = 0;  ///< both ≥ 0
};
struct KnownRadiusContradicted {
  double nominal = 0, pulledBy = 0, bound = 0;
};
/// The radius from the readings contradicts an R0 that has a σ, in a model with a free radius.
struct NominalRadiusContradicted {
  double nominal = 0, away = 0, bound = 0;  ///< R0; fitted radius minus R0, and its bound
};
/// A position has the same readings as an earlier one at its axis angle.
struct PositionCopied {
  int axisDeg = 0, repeat = 1, earlier = 1;  ///< `earlier`: repeat of the other
};
struct UnknownEffect {
  std::string id;
};
/// A known value refers to no parameter of the catalogue.
struct KnownOfNothing {
  std::string effect, parameter, unit;
};
/// Rows differ in the corrections of the instrument, or only some rows state any: all are ignored.
struct CorrectionsDiffer {
  std::vector<std::string> switches;  ///< keys of their switches in a row
};
/// Rows state tilts, but no row states whether the instrument has corrected for them.
struct TiltsUnused {};
/// The compensator reading changed from one position to another.
struct AxisMoved {
  Angle change;  ///< ≥ 0
};
/// The mean compensator reading of both faces deviates from zero.
struct CompensatorOff {
  Angle index;  ///< ≥ 0
};
/// The vertical circle is modelled as reading y/L.
struct PlanarRelation {};

}  // namespace session_finding

struct ArcFinding {
  int axisDeg = 0;
  arc_finding::What what;
  int repeat = 1;
};

struct FitFinding {
  using What = std::variant<
      ArcFinding, setup_finding::DistanceTooShort, setup_finding::PlacesOnTheWrongSide,
      setup_finding::ZeroOfOtherCircle, setup_finding::SlidersDiffer, setup_finding::ZerosAlike,
      setup_finding::ZerosDiffer, setup_finding::ReadingsRounded, setup_finding::ZeroMoved,
      setup_finding::ZeroFaceLeftOut, session_finding::ArcMissing, session_finding::Undetermined,
      session_finding::PositionMissing, session_finding::RadiiDiffer, session_finding::CentresDiffer,
      session_finding::KnownRadiusContradicted, session_finding::NominalRadiusContradicted,
      session_finding::PositionCopied, session_finding::UnknownEffect, session_finding::KnownOfNothing,
      session_finding::CorrectionsDiffer, session_finding::TiltsUnused, session_finding::AxisMoved,
      session_finding::CompensatorOff, session_finding::PlanarRelation>;

  Severity severity = Severity::Warning;  ///< Error: the reason why one arc or all arcs are missing
  Place where;
  What what;
};

}  // namespace alidade
