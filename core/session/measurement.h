#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/angle.h"
#include "core/base/angle_text.h"
#include "core/base/problem.h"
#include "core/session/own_effects.h"
#include "core/session/session.h"

namespace alidade {

enum class PointingZeros {
  Unstated,  ///< treated as Each
  Each,      ///< every position has its own
  One,       ///< sighted once for all positions
};

/// The orientation of the arc plane if the pointing zero is inclined to the horizon.
enum class ArcPlane {
  Vertical,  ///< plumb for any elevation of the zero
  Square,    ///< perpendicular to the pointing zero
};

/// The target of the pointing zeros.
enum class ZeroIs {
  Unstated,  ///< a mark if the zeros agree
  Mark,      ///< one fixed direction
  Normal,    ///< the guideway's own normal, set again in each position
  Unknown,
};

enum class VerticalCircle { Zenith, Elevation };

/// The relation between a vertical circle reading and the target (x, y, −L).
enum class VerticalAngleRelation {
  Exact,   ///< tan e = y/√(x² + L²): what a theodolite reads
  Planar,  ///< tan e = y/L: the published relation
};

/// The treatment of the radius in the fit.
enum class RadiusModel {
  Free,    ///< each position has its own
  Common,  ///< one radius for all positions, as of one rigid guideway
  Known,   ///< one radius for all positions, with R0 and its σ as prior
};

/// The quantity that a tolerance limits: the distance of the arc's centre from the axis, or a component of
/// it.
enum class Measurand {
  Intersection,  ///< the component in the plane of the arc, Δd
  Distance,      ///< the whole distance, including the part across the plane
};

/// The corrections that an instrument applied to its readings.
struct Corrections {
  bool inclination = false;   ///< both circles are corrected by the compensator reading
  bool standingAxis = false;  ///< the horizontal circle is corrected by the compensator reading
  bool collimation = false;   ///< corrected by the instrument's own calibration, like `tiltingAxis`
  bool tiltingAxis = false;

  bool operator==(const Corrections&) const = default;
};

/// One row of readings, reduced: face 1 equivalent, relative to the pointing zero, right and up positive,
/// |a|, |e| < 90°.
struct Sighting {
  std::size_t row = 0;       ///< index into the position's readings
  std::size_t sequence = 0;  ///< index among all rows of the session, excluded ones too, in the order taken
  std::size_t order = 0;     ///< `sequence` plus the number of earlier sightings of zeros
  double elapsed = 0;        ///< share of the session elapsed when it was taken, 0…1
  int point = 0;
  int round = 1;
  int face = 1;
  Angle a;  ///< horizontal, right positive
  Angle e;  ///< vertical, up positive
  std::optional<Angle> slider;
  std::optional<Angle> tiltCross = {}, tiltLength = {};  ///< compensator readings (compensator.h)
  std::optional<Corrections> corrections = {};           ///< switches that were on, if known
  std::optional<double> minutes = {};                    ///< time on any clock, if stated
  bool isZero = false;  ///< a sighting of a pointing zero that is an observation
};

/// One sighting of a pointing zero.
struct SightedZero {
  int face = 1;
  bool isAfter = false;  ///< sighted after the rows of its position; else before them
  Angle a, e;            ///< sighting minus the position's zero, in face 1; right and up positive
  std::optional<double> minutes = {};
  std::size_t order = 0;  ///< as in `Sighting`
  double elapsed = 0;
};

/// The sightings whose mean is the pointing zero.
struct ZeroSightings {
  int count = 1;
  bool isInBothFaces = false;   ///< the mean weights both faces equally; else all are in face 1
  double factor = 1;            ///< σ of the mean divided by that of a single sighting
  double elapsed = 0;           ///< share of the session elapsed at their mean moment, where drift is 0
  bool hasLeftOutFace = false;  ///< face 2 is ignored, since not all positions have it
  /// Change from before to after the readings, in face 1; absent unless one face was sighted both times.
  struct Move {
    Angle horizontal, vertical;
    double factor = 1;  ///< σ of either divided by that of a single sighting
    /// Half of what face 2 changed more than face 1, with the same σ; 0 if one face was sighted both times.
    Angle apartHorizontal = {}, apartVertical = {};
  };
  std::optional<Move> moved = {};
};

/// The readings of one position of the axis, without excluded and unusable rows.
struct ArcMeasurement {
  std::size_t position = 0;            ///< index into the session's positions
  int axisDeg = 0;                     ///< 0 or 180
  Angle zeroHorizontal, zeroVertical;  ///< α0 and β0: mean circle readings of `zero`, as in face 1
  std::vector<Sighting> sightings;
  int repeat = 1;  ///< repeat at this axis in the session
  ZeroSightings zero = {};
  std::vector<SightedZero> zeroSightings = {};  ///< sightings that count; of a common zero, the first arc
                                                ///< has those before its rows, the last those after
  /// e0: elevation of the pointing zero above the horizon, up positive. It is 0 if it would exceed 45°: the
  /// vertical circle then does not count from the plumb line.
  Angle zeroElevation = {};
};

/// Prior knowledge of one parameter of an effect, entered at `where`. `findParameter` (known_sizes.h) finds
/// the catalogue's parameter, if there is one.
struct KnownNumber {
  Place where = {};
  std::string effect = {}, parameter = {}, unit = {}, from = {}, date = {};
  double value = 0, sigma = 0;  ///< in `unit`; σ > 0
  /// Probability that the value is outdated because the instrument was knocked or adjusted since. The default
  /// is one in fifty records.
  double staleChance = 0.02;
};

/// For each circle: do the zeros of all positions sight one mark with this circle unchanged?
struct CommonZeros {
  bool horizontal = false, vertical = false;

  bool operator==(const CommonZeros&) const = default;
};

/// The meaning of a session: every value present, in range and in the reference frame o0. Lengths in mm.
struct Measurement {
  double distance = 0;       ///< L > 0
  double sigmaDistance = 0;  ///< ≥ 0
  double nominalRadius = 0;  ///< R0 > 0
  double sigmaRadius = 0;    ///< σ of R0, ≥ 0; used for a known radius, else for the closure R − R0
  /// Expansion of L and R0 from 20 °C to the temperature of the session, in mm; L and R0 above include it.
  double distanceExpansion = 0, radiusExpansion = 0;
  RadiusModel radiusModel = RadiusModel::Free;
  Angle sigmaHorizontal, sigmaVertical;          ///< σ of a circle reading, > 0
  Angle sigmaZeroHorizontal, sigmaZeroVertical;  ///< σ of one sighting of a pointing zero, ≥ 0
  /// No σ of the zeros is stated: their sightings are circle readings and scatter like these.
  bool zerosAreReadings = false;
  /// Factor by which sightings of one zero differ more than their σ allows; ≥ 1.
  double zeroScatter = 1;
  PointingZeros pointingZeros = PointingZeros::Unstated;
  /// Present if the zeros' sightings follow the rows of their arcs as observations (sighted_zeros.h).
  std::optional<CommonZeros> sightedZeros = {};
  ArcPlane plane = ArcPlane::Vertical;
  bool isPlaneStated = true;  ///< else the plane may be perpendicular to the zero
  ZeroIs zeroIs = ZeroIs::Unstated;
  Angle sigmaSlider;                                  ///< > 0
  Angle sigmaCompensator = Angle::fromArcseconds(1);  ///< σ of the compensator's setting or reading, > 0
  VerticalCircle verticalCircle = VerticalCircle::Zenith;
  CircleUnit angleUnit = CircleUnit::Dms;  ///< unit of displayed angles
  VerticalAngleRelation relation = VerticalAngleRelation::Exact;
  std::optional<double> tolerance;                ///< mm, > 0
  Measurand measurand = Measurand::Intersection;  ///< the quantity that the tolerance limits
  double coverage = 0.95;                         ///< in (0, 1)
  std::optional<double> referenceIntersection;    ///< mm
  std::optional<double> sigmaReference;           ///< mm, > 0; only with a reference, if stated
  std::vector<ArcMeasurement> arcs;               ///< one for each position, in the order taken
  std::size_t rows = 0;                           ///< rows of the whole session, excluded ones included
  double pauseRows = 0;  ///< number of rows that would fit between two positions; used if rows have no times
  std::vector<std::string> effects;            ///< ids of model.effects, to be estimated
  std::vector<KnownNumber> known;              ///< known sizes of instrument, device and compensator
  std::shared_ptr<const OwnEffects> own = {};  ///< the user's own effects; null: none

  /// Is there a single zero, with the same error in every arc?
  bool hasOneZero() const { return pointingZeros == PointingZeros::One; }

  /// σ of the mean of the sightings of an arc's zero, including their scatter.
  Angle sigmaOfZeroHorizontal(const ArcMeasurement& arc) const {
    return sigmaZeroHorizontal * (zeroScatter * arc.zero.factor);
  }
  Angle sigmaOfZeroVertical(const ArcMeasurement& arc) const {
    return sigmaZeroVertical * (zeroScatter * arc.zero.factor);
  }
};

/// Does every row state its time, so that moments do not depend on row counts?
bool hasTimes(const Measurement& measurement);

/// Numbers rows and sightings of zeros in the order taken, and sets the elapsed share of the session: from
/// times if every row has one, else from row numbers. A zero without a time is placed just before the first
/// row of its position, or just after the last; a common zero before or after all rows.
void setMoments(Measurement& measurement);

/// For each arc, returns the index of the first arc at the same axis angle: an arc's own index if it is not a
/// repeat. The arcs of one axis angle share centre and radius.
std::vector<std::size_t> firstAtTheirAxes(const Measurement& measurement);

/// Is any axis measured more than once?
bool hasRepeats(const Measurement& measurement);

/// Do all arcs have the same pointing zero? False for a single arc.
bool hasAlikeZeros(const Measurement& measurement);

/// Are there arcs at 0° and at 180°, so that there is an intersection?
bool hasBothAxes(const Measurement& measurement);

/// The result of examining a session: the usable part, and a problem for each unusable entry, in the order of
/// the file.
struct Examined {
  std::optional<Measurement> measurement;  ///< absent if L, R0, a σ or the model itself is unusable
  std::vector<Problem> problems;           ///< empty: the whole session is sound
};

/// Converts the texts of a session to a measurement. Rows with an unusable entry, and positions with an
/// unusable pointing zero, are left out and reported, as are rows without any entry. Excluded rows are not
/// examined. Of two rows with the same point, round and face in one position the second is reported and left
/// out. If the coverage is unusable, the tolerance is not used: a verdict needs a chosen level.
Examined examine(const Session& session);

/// Returns the reason why `text` is unusable as the value of `field`; absent if it is usable. Applies the
/// rules of `examine` for single entries, with the session's kind of vertical circle, to mark the entry in
/// place. `field` is a name of the session file without indices: `geometry.distance_mm`,
/// `pointing_zero.vertical`, `readings.horizontal`, `readings.face`, `acceptance.coverage`, `axis_deg`,
/// `measured_on`, `device.known.sigma`, …
std::optional<std::string> entryProblem(const Session& session, const std::string& field,
                                        const std::string& text);

}  // namespace alidade
