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

/// How the plane of the arc stands where the pointing zero is inclined against the horizon.
enum class ArcPlane {
  Vertical,  ///< plumb, whatever the zero's elevation
  Square,    ///< perpendicular to the pointing zero
};

/// What the pointing zeros of the positions sight.
enum class ZeroIs {
  Unstated,  ///< a mark where they agree
  Mark,      ///< one fixed direction
  Normal,    ///< the guideway's own normal, set anew in each position
  Unknown,
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
  std::size_t order = 0;     ///< the same with the sightings of the zeros counted among the rows
  double elapsed = 0;        ///< share of the session gone by when it was taken, 0…1
  int point = 0;
  int round = 1;
  int face = 1;
  Angle a;  ///< horizontal, right positive
  Angle e;  ///< vertical, up positive
  std::optional<Angle> slider;
  std::optional<Angle> tiltCross = {}, tiltLength = {};  ///< of the vertical axis, as compensator.h has them
  std::optional<Corrections> corrections = {};           ///< that were on, where that is known
  std::optional<double> minutes = {};                    ///< when, on any clock; where its time is stated
  bool isZero = false;  ///< of a pointing zero, where it takes part as an observation
};

/// One sighting of a pointing zero.
struct SightedZero {
  int face = 1;
  bool isAfter = false;  ///< behind the rows of its position; else before them
  Angle a, e;            ///< from the position's zero, as face 1 has it; right and up positive
  std::optional<double> minutes = {};
  std::size_t order = 0;  ///< as of a row
  double elapsed = 0;
};

/// How a pointing zero was sighted, that is the mean of some sightings.
struct ZeroSightings {
  int count = 1;
  bool isInBothFaces = false;   ///< which weigh alike; else in face 1
  double factor = 1;            ///< σ of the mean over that of a single sighting
  double elapsed = 0;           ///< when a zero is sighted that reads as their mean: a drift counts from then
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
  std::vector<SightedZero> zeroSightings = {};  ///< that count; of one zero for all, in the arc next to it
  /// e0: of the pointing zero over the horizon, up positive; 0 where the vertical circle cannot count from
  /// the plumb line.
  Angle zeroElevation = {};
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

/// In which of their directions the zeros of all positions sight one mark, its circle as it was.
struct CommonZeros {
  bool horizontal = false, vertical = false;

  bool operator==(const CommonZeros&) const = default;
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
  /// The sightings of the zeros stand behind the rows of their arcs, as observations (sighted_zeros.h).
  std::optional<CommonZeros> sightedZeros = {};
  ArcPlane plane = ArcPlane::Vertical;
  bool isPlaneStated = true;  ///< else it may as well be square to the zero
  ZeroIs zeroIs = ZeroIs::Unstated;
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
  double pauseRows = 0;  ///< how many rows would fit between two positions; of use where rows have no times
  std::vector<std::string> effects;  ///< ids of model.effects, to be estimated along
  std::vector<KnownNumber> known;    ///< of the instrument, then of the device

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

/// Every row says when it was read, so that the moments need no rows to count them.
bool hasTimes(const Measurement& measurement);

/// Numbers rows and sightings of zeros in the order taken, and says how much of the session was gone by: by
/// their times where every row has one, else by the rows. A zero without a time of its own is sighted just
/// before the first row of its position, or just behind the last; one for all, before the first of all.
void setMoments(Measurement& measurement);

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
