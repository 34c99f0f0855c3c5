#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/adjustment/result/closures.h"
#include "core/adjustment/result/intersection.h"
#include "core/base/normal_mixture.h"
#include "core/diagnosis/result/form.h"
#include "core/observation/reading_ref.h"

namespace alidade {

enum class DiagnosisVerdict {
  WithinNoise,     ///< nothing to explain
  SingleCause,     ///< one cause without look-alikes in these readings
  Ambiguous,       ///< one cause of a group that these readings cannot separate
  SeveralCauses,   ///< the causes in `causes`, or more causes than these readings can separate
  NotInCatalogue,  ///< the gap is real, and no effect or combination explains it
};

/// "within-noise", "single-cause", …
std::string_view nameOf(DiagnosisVerdict verdict);

/// The size of the gap after a fit. Without redundancy only rms is a number.
struct GapSize {
  double rms = 0;  ///< rms residual of the circle readings, arcseconds
  /// χ²/f with the stated noise, or with the estimated noise if it is larger.
  double reducedChiSquare = std::numeric_limits<double>::quiet_NaN();
  /// Probability of at least this χ² by noise alone.
  double pValue = std::numeric_limits<double>::quiet_NaN();
};

/// The reduction of the gap, each number in 0…1 unless the gap grows.
struct Shrinkage {
  double inSample = 0;  ///< 1 − rms after/rms before
  double ofExcess = 0;  ///< 1 − (χ² − f after)/(χ² − f before)
  /// 1 − rms after/rms before on readings that were held out of the fit of circles and causes. The set of
  /// causes, the moments of jumps and the readings with gross errors still come from all readings. Not a
  /// number if too few readings exist.
  double heldOut = 0;
};

struct CauseParameter {
  std::string name;
  double value = 0, sigma = 0;
  std::string unit;  ///< as in the catalogue
};

/// A reading with its deviation.
struct ReadingDeviation {
  std::size_t position = 0, row = 0;  ///< indices in the session
  int axisDeg = 0, round = 1, point = 0, face = 1;
  int repeat = 1;  ///< as `ArcMeasurement::repeat`
  ReadingKind kind = ReadingKind::Horizontal;
  bool isZero = false, isAfter = false;  ///< of a pointing zero, as `SightedZero::isAfter`; not of a row
  /// Arcseconds. In a cause: the error of the reading, with the sign of its circle. In `Diagnosis::readings`:
  /// the residual (`AdjustedReading::residual`).
  double size = 0;
};

/// The known value of a parameter of an effect, and its value from these readings.
struct KnownCheck {
  std::string effect;      ///< identifier in the catalogue
  std::string name, unit;  ///< of the parameter, as in the catalogue
  double known = 0, sigmaKnown = 0;
  std::string from, date;       ///< as stated in the session
  double value = 0, sigma = 0;  ///< from the readings alone, with the causes found; valid if `isSeen`
  bool isSeen = false;          ///< whether the readings determine the parameter
  double staleChance = 0;       ///< probability that the known value is out of date, 0…1
};

struct Cause {
  std::string effect;      ///< identifier in the catalogue
  double probability = 0;  ///< probability that the effect is among the causes, 0…1
  std::vector<CauseParameter> parameters = {};
  std::vector<std::string> indistinguishableFrom = {};  ///< identifiers
  std::vector<ReadingDeviation> readings = {};          ///< the readings with a gross error
  bool isStale = false;  ///< the known value is out of date: see `Diagnosis::known`
  /// Identifiers of further look-alikes, which only the known value excludes.
  std::vector<std::string> unlessStale = {};
};

/// An effect, and how well it alone explains the readings.
struct Candidate {
  std::string effect;
  double logBayesFactor = 0;  ///< natural logarithm, against no effect
  double visibleSigma = 0;    ///< length of the explained part, σ of the readings
};

/// A part of the gap. The shares with the same `by` sum to 1.
struct GapShare {
  std::string by;    ///< "frame", "position", "circle", "face", "round", "sector", "time", "closure"
  std::string of;    ///< the part, such as "guideway", "horizontal" or "60…90°"
  double share = 0;  ///< share of the leftover beyond the noise, 0…1
};

/// Δd, y up, mm.
struct IntersectionEstimate {
  double value = 0, sigma = 0, expanded = 0;
  /// Distribution of Δd, mm: one explanation of the readings, or all possible explanations with their
  /// probabilities. Each explanation follows Student's distribution about its mean.
  std::vector<NormalPart> explanations = {};
  double degreesOfFreedom = 0;  ///< effective degrees of freedom of the explanations; may be infinite
};

/// The name of the distribution: "normal", "Student's t", or "mixture of Student's t" of several
/// explanations.
const char* distributionOf(const IntersectionEstimate& estimate);

/// Returns the estimate of the session's own model.
IntersectionEstimate estimateOf(const Intersection& intersection);

/// The plausible or known size (1σ) of one parameter of an effect.
struct PlausibleSize {
  std::string name;
  double sigma = 0;
  std::string unit;  ///< as in the catalogue
};

/// A contribution to the standard uncertainty of the measured Δd; its distribution is assumed to be normal.
struct UncertaintyShare {
  enum class Type { A, B };  ///< statistical analysis of these readings, or other knowledge (JCGM 100, 3.3.4)
  enum class From { Scatter, Stated, Default, Known, Diagnosis };  ///< origin of its size

  UncertaintySource source = UncertaintySource::PlausibleSizes;
  std::string effect = {};  ///< identifier, for PlausibleSizes; empty: other possible explanations
  Type type = Type::B;
  From from = From::Stated;
  double sigma = 0;                       ///< mm
  std::string reference = {};             ///< source of a known size, as stated in the session
  std::vector<PlausibleSize> sizes = {};  ///< for an effect
  double degreesOfFreedom = std::numeric_limits<double>::infinity();
};

/// A length, mm, with its standard and its expanded uncertainty.
struct MeasuredLength {
  double value = 0, sigma = 0, expanded = 0;
};

struct MeasuredIntersection {
  IntersectionEstimate estimate;
  std::vector<UncertaintyShare> budget = {};  ///< the largest first; the squares sum to σ²
  /// Offset of the arc's centre from the axis, perpendicular to the plane of the arc; positive towards the
  /// observer at axis angle 0°. Readings (through the radii) or known sizes determine it, plausible sizes
  /// never do. Absent if neither readings nor known sizes determine it.
  std::optional<MeasuredLength> across = {};
  std::optional<MeasuredLength> distance = {};  ///< total distance of the centre from the axis, `across`
                                                ///< included
};

/// One step of the reduction of the gap: a cause is added.
struct GapStep {
  std::string effect;  ///< the cause added
  GapSize size;        ///< the gap after this step
  std::optional<IntersectionEstimate> intersection;
  std::vector<Closure> closures = {};  ///< closures of the session's own model after this step
};

/// A closure of the session's own model, and of the model with the causes.
struct ClosureStep {
  Closure before;
  std::optional<Closure> after = {};  ///< absent if the readings do not determine it with the causes

  /// The closure with the causes found, or without them if `after` is absent.
  const Closure& latest() const { return after ? *after : before; }
  /// Whether the closure fails even with the causes found.
  bool isOpen() const { return fails(latest()); }
};

/// An effect that is undetectable in these readings.
struct UndetectableEffect {
  std::string effect;
  double influence = 0;     ///< change of Δd by the plausible size, mm, ≥ 0
  double visibleSigma = 0;  ///< length of its trace in the readings, σ
};

/// Undetectable jumps (knocks of the tripod) within one position.
struct UndetectableJump {
  int axisDeg = 0, repeat = 1;  ///< the position, as in `ArcMeasurement`
  bool isAfterZero = false;     ///< between the pointing zero and the first sighting; otherwise during the
                                ///< readings
  double influence = 0;         ///< change of Δd by the plausible size, mm, ≥ 0
  /// The distribution of the change of Δd, mm: one part for each possible prior width of the jump. `share` is
  /// the fraction of all sessions with such a jump, far below 1; `sigma` is the σ of the change.
  std::vector<NormalPart> moves = {};
};

/// The part of the gap without an explanation (`unexplainedOf`).
struct Unexplained {
  double chance = 0;  ///< probability that the gap is real and not explained by the catalogue, 0…1
  double sigma = 0;   ///< possible change of Δd by unexplained misclosures, 1σ, mm
};

/// A way to take more readings.
enum class Measure {
  BothFaces,
  WayBack,  ///< repeats the visits in reverse order, as another round
  SliderReadings,
  ShiftedCircle,   ///< a second set with the horizontal circle shifted by 60°
  SecondStandOff,  ///< a second set from 1.5 times the distance
  MoreOfTheArc,
  ZeroSightedAgain,
  DistanceInBoth,  ///< measures the distance in both positions
  At0Again,        ///< repeats the position at 0° at the end, with its own pointing zero
  At180Again,
};

/// Further readings, and the causes that they separate.
struct Advice {
  std::vector<Measure> measures = {};       ///< to be taken in combination
  std::vector<std::string> separates = {};  ///< identifiers; any two of them are separated, whichever of the
                                            ///< two is the cause
  double bySigma = 0;                       ///< smallest difference of two of them, σ
  /// Probability that the look-alikes of these readings reduce to one answer.
  double oneLeft = 0;
  bool ofUndetectable = false;  ///< `separates` lists undetectable effects, revealed with `bySigma` or more
};

/// Whether one of the measures requires a new session; otherwise the readings are added to this one.
bool isNewSessionNeeded(const std::vector<Measure>& measures);
/// The effort of the measures, in sessions like this one.
double effortOf(const std::vector<Measure>& measures);

/// The size at which an effect explains the difference of Δd from the reference.
struct Required {
  std::string effect;
  double size = 0;  ///< for an effect of two parameters, the length of their vector
  std::string unit;
  double plausibleSizes = 0;
  double visibleSigma = 0;  ///< length of its trace in these readings, σ
};

/// U of Δd in sessions like this one, with more readings or a known effect.
struct AttainableUncertainty {
  std::vector<Measure> measures = {};  ///< additional measures
  std::string known = {};              ///< an effect whose size is known, for example from a certificate
  double expanded = 0;                 ///< U, mm
};

/// The shape of a gap that no effect explains.
struct GapShape {
  std::string follows;  ///< the argument of the pattern: "radius along the guideway", …
  double share = 0;     ///< share of the gap that the pattern explains, 0…1
};

struct Diagnosis {
  DiagnosisVerdict verdict = DiagnosisVerdict::WithinNoise;
  /// With SeveralCauses: all catalogue effects together explain the gap at least as well as any pattern, but
  /// these readings cannot separate them. `causes` then holds the certain causes.
  bool hasMoreCausesThanSeparable = false;
  /// Ratio of the noise that remains beside the causes to the stated noise, ≥ 1.
  double noise = 1;
  GapSize gap, after;
  Shrinkage shrink;
  std::vector<Cause> causes;          ///< the most certain first
  std::vector<Candidate> candidates;  ///< the best first
  std::vector<KnownCheck> known;      ///< in the order of the catalogue
  std::vector<GapShare> where;
  /// First the known sizes (`knownId`), if any; then one step for each cause, gross errors first.
  std::vector<GapStep> steps;
  /// Δd of the session's own model; Δd with the causes found, averaged over alternatives (`Beyond`).
  std::optional<IntersectionEstimate> before, afterwards;
  /// Δd with all possible effects: the result of the measurement.
  std::optional<MeasuredIntersection> measured;
  std::vector<ClosureStep> closures;
  Unexplained unexplained;
  std::vector<UndetectableEffect> undetectable;     ///< the largest influence first
  std::vector<UndetectableJump> undetectableJumps;  ///< in the order of the positions
  /// Effects at the size that explains the difference from the reference, if these readings do not exclude
  /// it; the most plausible first. Empty without a reference with its σ.
  std::vector<Required> whatItWouldTake;
  std::vector<Advice> advice;  ///< the most effective first
  /// Filled on request; the first entry is without further measures (`attainableUncertainties`). Empty with
  /// NotInCatalogue.
  std::vector<AttainableUncertainty> attainable;
  std::optional<GapShape> shape;           ///< with NotInCatalogue
  std::vector<FoundForm> forms;            ///< with NotInCatalogue; empty if none is better than the pattern
  std::vector<ReadingDeviation> readings;  ///< all readings of the fit; `size` is the residual without causes
};

/// Whether a closure fails even with the causes found.
bool isMisclosed(const Diagnosis& diagnosis);

struct DiagnosisOptions {
  /// Identifiers of excluded effects.
  std::vector<std::string> without = {};
  /// A reference intersection stated with its σ counts as evidence for the causes. It never enters
  /// `Diagnosis::afterwards`.
  bool withReference = false;
  /// Computes `Diagnosis::attainable`, which takes two thirds of the time of all the rest.
  bool withAttainable = false;
  /// Computes only the input of a verdict (`decideAcceptance`), in half the time: causes, `measured`,
  /// closures, `unexplained` and `undetectableJumps`.
  bool forVerdict = false;
};

/// What `Diagnosis::afterwards` includes beyond the fit with the causes.
enum class Beyond {
  Nothing,
  Pattern,     ///< the possible change of Δd by the pattern
  LookAlikes,  ///< the average over the look-alikes
  Others,      ///< the average over other possible causes
};

Beyond beyondTheFit(const Diagnosis& diagnosis);

}  // namespace alidade
