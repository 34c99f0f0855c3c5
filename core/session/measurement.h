#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/angle.h"
#include "core/base/circle_unit.h"
#include "core/base/place.h"
#include "core/base/problem.h"
#include "core/session/session.h"

namespace alidade {

enum class PointingZeros {
  Unstated,  ///< taken as Each
  Each,      ///< every position has its own
  One,       ///< sighted once, for all positions
};

enum class VerticalCircle { Zenith, Elevation };

/// How a vertical circle reading follows from the target (x, y, −L).
enum class VerticalAngleRelation {
  Exact,   ///< tan e = y/√(x² + L²): what a theodolite reads
  Planar,  ///< tan e = y/L: the published relation
};

/// What the fit takes the radius for.
enum class RadiusModel {
  Free,    ///< each position has its own
  Common,  ///< one for both positions, as of one rigid guideway
  Known,   ///< one for both, observed beforehand: R0 with its σ
};

/// What a tolerance limits: of the distance of the arc's centre from the axis …
enum class Measurand {
  Intersection,  ///< … the component in the plane of the arc, Δd
  Distance,      ///< … all of it, across the plane, too
};

/// What an instrument took off its readings by itself.
struct Corrections {
  bool inclination = false;   ///< of both circles, by what its compensator read
  bool standingAxis = false;  ///< of the horizontal circle, by the same
  bool collimation = false;   ///< by its own calibration, as the next
  bool tiltingAxis = false;

  bool operator==(const Corrections&) const = default;
};

/// One row of readings, reduced: face 1 equivalent, from the pointing zero, right and up positive, |a|, |e| <
/// 90°.
struct Sighting {
  std::size_t row = 0;       ///< index into the position's readings
  std::size_t sequence = 0;  ///< index into all rows of the session, excluded ones too, in the order taken
  int point = 0;
  int round = 1;
  int face = 1;
  Angle a;  ///< horizontal, right positive
  Angle e;  ///< vertical, up positive
  std::optional<Angle> slider;
  std::optional<Angle> tiltCross = {}, tiltLength = {};  ///< of the vertical axis, as compensator.h has them
  std::optional<Corrections> corrections = {};           ///< that were on, where that is known
};

/// How a pointing zero was sighted, that is the mean of some sightings.
struct ZeroSightings {
  int count = 1;
  bool isInBothFaces = false;   ///< which weigh alike; else in face 1
  double factor = 1;            ///< σ of the mean over that of a single sighting
  bool isSpanning = false;      ///< before and after the readings: a drift counts from the middle of them
  bool hasLeftOutFace = false;  ///< face 2 was left out, since not all positions have it
  /// By what it moved from before to after, as face 1 reads it; where it was sighted both times in one face.
  struct Move {
    Angle horizontal, vertical;
    double factor = 1;  ///< σ of either over that of a single sighting
  };
  std::optional<Move> moved = {};
};

/// What was read in one position of the axis, excluded and unusable rows left out.
struct ArcMeasurement {
  std::size_t position = 0;            ///< index into the session's positions
  int axisDeg = 0;                     ///< 0 or 180
  Angle zeroHorizontal, zeroVertical;  ///< α0 and β0 as read, as face 1 has them
  std::vector<Sighting> sightings;
  int time = 1;  ///< the how many-th position of the session at this axis
  ZeroSightings zero = {};
};

/// What is known beforehand of one number of an effect, as it stands at `where`. Which number of the
/// catalogue is meant, if any: `parameterMeant` (known_sizes.h).
struct KnownNumber {
  Place where = {};
  std::string effect = {}, parameter = {}, unit = {}, from = {}, date = {};
  double value = 0, sigma = 0;  ///< in that unit, σ > 0
  /// Chance that it holds no longer: the instrument was knocked or adjusted since. Of such records, one in
  /// fifty.
  double staleChance = 0.02;
};

/// What a session means: every value present, in range and in the reference frame o0. Lengths in mm.
struct Measurement {
  double distance = 0;       ///< L > 0
  double sigmaDistance = 0;  ///< ≥ 0
  double nominalRadius = 0;  ///< R0 > 0
  double sigmaRadius = 0;    ///< of R0, ≥ 0; of use where the radius is known, and as a closure
  /// By what L and R0 are longer than stated, at the temperature of the session instead of 20 °C; already in
  /// both.
  double distanceExpansion = 0, radiusExpansion = 0;
  RadiusModel radiusModel = RadiusModel::Free;
  Angle sigmaHorizontal, sigmaVertical;          ///< of a circle reading, > 0
  Angle sigmaZeroHorizontal, sigmaZeroVertical;  ///< of one sighting of a pointing zero, ≥ 0
  /// No σ of the zeros is stated: their sightings are readings of the circles, and scatter as these do.
  bool zerosAreReadings = false;
  /// By how much sightings of one zero differ from one to the next more than their σ has it; ≥ 1.
  double zeroScatter = 1;
  PointingZeros pointingZeros = PointingZeros::Unstated;
  Angle sigmaSlider;                                  ///< > 0
  Angle sigmaCompensator = Angle::fromArcseconds(1);  ///< of what it sets to or reads, > 0
  VerticalCircle verticalCircle = VerticalCircle::Zenith;
  CircleUnit angleUnit = CircleUnit::Dms;  ///< in which angles are shown
  VerticalAngleRelation relation = VerticalAngleRelation::Exact;
  std::optional<double> tolerance;                ///< mm, > 0
  Measurand measurand = Measurand::Intersection;  ///< that it is of
  double coverage = 0.95;                         ///< in (0, 1)
  std::optional<double> referenceIntersection;    ///< mm
  std::optional<double> sigmaReference;           ///< mm, > 0; only with a reference, where stated
  std::vector<ArcMeasurement> arcs;               ///< of each position, in the order taken
  std::size_t rows = 0;                           ///< of the whole session, excluded ones too
  std::vector<std::string> effects;               ///< ids of model.effects, to be estimated along
  std::vector<KnownNumber> known;                 ///< of the instrument, then of the device

  /// One zero, wrong by the same in every arc.
  bool hasOneZero() const { return pointingZeros == PointingZeros::One; }

  /// Of the mean of the sightings of an arc's zero, as they scatter.
  Angle sigmaOfZeroHorizontal(const ArcMeasurement& arc) const {
    return sigmaZeroHorizontal * (zeroScatter * arc.zero.factor);
  }
  Angle sigmaOfZeroVertical(const ArcMeasurement& arc) const {
    return sigmaZeroVertical * (zeroScatter * arc.zero.factor);
  }
};

/// Of each arc the first one at its axis, itself unless its position is one measured again: the arcs of one
/// axis have one centre and radius.
std::vector<std::size_t> firstAtTheirAxes(const Measurement& measurement);

/// Is any axis measured more than once?
bool hasRepeats(const Measurement& measurement);

/// Have all arcs the same pointing zero? False of a single arc.
bool hasAlikeZeros(const Measurement& measurement);

/// Are there arcs at 0° and at 180°, so that there is an intersection?
bool hasBothAxes(const Measurement& measurement);

/// A session examined: what can be used, and a sentence for everything that cannot, in the order of the file.
struct Examined {
  std::optional<Measurement> measurement;  ///< absent where L, R0, a σ or the model itself is unusable
  std::vector<Problem> problems;           ///< empty: the whole session is sound
};

/// Works out what the texts of a session mean. Rows with an unusable entry, and positions with an unusable
/// pointing zero, are left out of the measurement and reported. Rows without any entry are incomplete, so
/// reported too. Excluded rows are not examined: they were excluded because they are of no use. Of two rows
/// with the same point, round and face in one position the second is reported and left out. Where the
/// coverage is unusable there is no tolerance either: no verdict rests on a level nobody chose.
Examined examine(const Session& session);

/// Is `text` usable as the value of the field at `where`? The sentence where it is not. For marking entries
/// in place: the same rules as `examine`, without the checks that need other entries. `field` is a name of
/// the session file without indices: `geometry.distance_mm`, `pointing_zero.vertical`, `readings.horizontal`,
/// `readings.face`, `acceptance.coverage`, `axis_deg`, `measured_on`, `device.known.sigma`, …
std::optional<std::string> entryProblem(const Session& session, const std::string& field,
                                        const std::string& text);

}  // namespace alidade
