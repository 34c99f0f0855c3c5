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

// What a diagnosis answers.

enum class DiagnosisVerdict {
  WithinNoise,     ///< nothing to explain
  SingleCause,     ///< one cause, and no other looks like it in these readings
  Ambiguous,       ///< one cause out of a group that these readings cannot tell apart
  SeveralCauses,   ///< each in `causes`, or more than can be taken apart
  NotInCatalogue,  ///< the gap is real, and no effect explains it, alone or together
};

/// "within-noise", "single-cause", …
std::string_view nameOf(DiagnosisVerdict verdict);

/// What a fit leaves over. Without redundancy only rms is a number.
struct GapSize {
  double rms = 0;  ///< of the circle readings' residuals, arcseconds
  /// With the noise stated; after larger noise was found, with that.
  double reducedChiSquare = std::numeric_limits<double>::quiet_NaN();
  /// Chance of so much by noise alone.
  double pValue = std::numeric_limits<double>::quiet_NaN();
};

/// How far the gap shrinks, each within 0…1 unless it grows.
struct Shrinkage {
  double inSample = 0;  ///< 1 − rms after/rms before
  double ofExcess = 0;  ///< 1 − (χ² − f after)/(χ² − f before)
  /// 1 − rms after/rms before on readings that took no part in estimating circles and sizes of the causes;
  /// which causes, at which moment or readings, all readings say. Not a number where too few are there.
  double heldOut = 0;
};

struct CauseParameter {
  std::string name;
  double value = 0, sigma = 0;
  std::string unit;  ///< as in the catalogue
};

/// A reading and by how much it deviates.
struct ReadingDeviation {
  std::size_t position = 0, row = 0;  ///< of the session
  int axisDeg = 0, round = 1, point = 0, face = 1;
  int time = 1;  ///< as `ArcMeasurement::time`
  ReadingKind kind = ReadingKind::Horizontal;
  /// How far it is off, arcseconds: of a cause as read on the circle, of `Diagnosis::readings` as
  /// `AdjustedReading::residual`.
  double size = 0;
};

/// What was known beforehand of a number of an effect, and what these readings say of it.
struct KnownCheck {
  std::string effect;      ///< id of the catalogue
  std::string name, unit;  ///< of the number, as in the catalogue
  double known = 0, sigmaKnown = 0;
  std::string from, date;       ///< as the session says it
  double value = 0, sigma = 0;  ///< by the readings alone, with the causes found; where they say anything
  bool isSeen = false;          ///< they do
  double staleChance = 0;       ///< that what was known holds no longer, 0…1
};

struct Cause {
  std::string effect;      ///< id of the catalogue
  double probability = 0;  ///< that it is among the causes, 0…1
  std::vector<CauseParameter> parameters;
  std::vector<std::string> indistinguishableFrom;  ///< ids
  std::vector<ReadingDeviation> readings;          ///< of a gross_error
  bool isStale = false;  ///< its size was known beforehand, and that holds no longer: see `Diagnosis::known`
  /// Ids of what these readings could not tell from it either, and what is known beforehand does.
  std::vector<std::string> unlessStale = {};
};

/// How well one effect alone explains the readings.
struct Candidate {
  std::string effect;
  double logBayesFactor = 0;  ///< natural, against no effect
  double visibleSigma = 0;    ///< length of what it explains, in σ of the readings
};

/// A part of the gap. The shares of one `by` add up to 1.
struct GapShare {
  std::string by;    ///< "frame", "position", "circle", "face", "round", "sector", "time", "closure"
  std::string of;    ///< in the order of their values
  double share = 0;  ///< of the leftover beyond the noise, 0…1
};

/// Δd, y up, mm.
struct IntersectionEstimate {
  double value = 0, sigma = 0, expanded = 0;
  /// What is believed of Δd, mm: one account of the readings, or each that they leave possible with its
  /// probability. About its mean each follows Student's distribution.
  std::vector<NormalPart> accounts = {};
  double degreesOfFreedom = 0;  ///< of that, effective; may be infinite
};

/// The same of the session's own model.
IntersectionEstimate estimateOf(const Intersection& intersection);

/// 1σ of what is plausible or known of one number of an effect.
struct PlausibleSize {
  std::string name;
  double sigma = 0;
  std::string unit;  ///< as in the catalogue
};

/// A share of the standard uncertainty of Δd as it was measured. Each is taken as normally distributed.
struct UncertaintyShare {
  enum class Type { A, B };  ///< by statistics of these readings, or by other knowledge (JCGM 100, 3.3.4)
  enum class From { Scatter, Stated, Default, Known, Diagnosis };  ///< where its size comes from

  UncertaintySource source = UncertaintySource::PlausibleSizes;
  std::string effect = {};  ///< id, with PlausibleSizes; empty: what else may explain the readings
  Type type = Type::B;
  From from = From::Stated;
  double sigma = 0;                       ///< mm
  std::string reference = {};             ///< where a known size is known from, as the session says it
  std::vector<PlausibleSize> sizes = {};  ///< of an effect
  double degreesOfFreedom = std::numeric_limits<double>::infinity();
};

/// A length, mm, with its standard and its expanded uncertainty.
struct MeasuredLength {
  double value = 0, sigma = 0, expanded = 0;
};

struct MeasuredIntersection {
  IntersectionEstimate estimate;
  std::vector<UncertaintyShare> budget = {};  ///< the greatest first; the squares add up to that of σ
  /// How far the arc's centre lies off the axis across the plane of the arc, at 0° towards the observer: by
  /// the readings, whose radii it makes differ, or by what is known of it, never by what is plausible. Absent
  /// where neither tells.
  std::optional<MeasuredLength> across = {};
  std::optional<MeasuredLength> distance = {};  ///< of the centre from the axis as a whole, with `across`
};

/// The gap as it shrinks, cause by cause.
struct GapStep {
  std::string effect;  ///< added in this step
  GapSize size;        ///< after it
  std::optional<IntersectionEstimate> intersection;
};

/// A closure as the session's own model has it, and with the causes in the model.
struct ClosureStep {
  Closure before;
  std::optional<Closure> after = {};  ///< absent where the readings do not determine it then

  /// With all that is known.
  const Closure& latest() const { return after ? *after : before; }
  /// It fails, and what was found does not account for it.
  bool isOpen() const { return fails(latest()); }
};

/// An effect that these readings would not show.
struct UndetectableEffect {
  std::string effect;
  double influence = 0;     ///< on Δd of its plausible size, mm, ≥ 0
  double visibleSigma = 0;  ///< what it would leave in the readings, σ
};

/// Knocks of the tripod while one position was set up that these readings would not show.
struct UndetectableJump {
  int axisDeg = 0, time = 1;  ///< of the position, as `ArcMeasurement`
  bool isAfterZero = false;   ///< between its pointing zero and its first sighting; else during its readings
  double influence = 0;       ///< on Δd of its plausible size, mm, ≥ 0
  /// What it moves Δd by, mm: for each width that its size may have the share of all sessions in which it
  /// occurs so, far below 1, and 1σ of the move.
  std::vector<NormalPart> moves = {};
};

/// What no explanation accounts for (`unexplainedOf`).
struct Unexplained {
  double chance = 0;  ///< that the gap is real and no effect of the catalogue accounts for it, 0…1
  double sigma = 0;   ///< what misclosures without an explanation may move Δd by, 1σ, mm
};

/// A way to read more.
enum class Measure {
  BothFaces,
  WayBack,  ///< the places once more in reverse, as another round
  SliderReadings,
  ShiftedCircle,   ///< a second set with the horizontal circle shifted by 60°
  SecondStandOff,  ///< a second set from half as far again
  MoreOfTheArc,
  ZeroSightedAgain,
  DistanceInBoth,  ///< the distance measured in both positions
  At0Again,        ///< the position at 0° once more behind all others, with its own pointing zero
  At180Again,
};

/// Further readings and what they would tell apart.
struct Advice {
  std::vector<Measure> measures = {};       ///< all of them together
  std::vector<std::string> separates = {};  ///< ids: every two of them, whichever is the cause
  double bySigma = 0;                       ///< difference of the least different two of them, σ
  /// Probability that one answer is left of all that these readings cannot tell apart.
  double oneLeft = 0;
  bool ofUndetectable = false;  ///< `separates`: what would show that does not yet, by `bySigma` or more
};

/// The session has to be read anew for one of them; else what is read comes beside it.
bool isReadAnew(const std::vector<Measure>& measures);

/// What it would take of an effect to explain how far Δd is from the reference.
struct Required {
  std::string effect;
  double size = 0;  ///< of two numbers the length
  std::string unit;
  double plausibleSizes = 0;
  double visibleSigma = 0;  ///< what it would leave in these readings, σ
};

/// U of Δd as sessions like this one have it, with more read or known.
struct AttainableUncertainty {
  std::vector<Measure> measures = {};  ///< taken besides
  std::string known = {};              ///< an effect whose size is known, by a certificate say
  double expanded = 0;                 ///< U, mm
};

/// A gap that fits no effect, by its shape.
struct GapShape {
  std::string follows;  ///< "radius along the guideway", …
  double share = 0;     ///< of the gap that the pattern takes up, 0…1
};

struct Diagnosis {
  DiagnosisVerdict verdict = DiagnosisVerdict::WithinNoise;
  /// With SeveralCauses: all effects of the catalogue together explain the gap at least as well as any
  /// pattern of no catalogue, and these readings cannot take them apart. `causes` holds what is certain
  /// beside them.
  bool hasMoreCausesThanSeparable = false;
  GapSize gap, after;
  Shrinkage shrink;
  std::vector<Cause> causes;          ///< the most certain first
  std::vector<Candidate> candidates;  ///< the best first
  std::vector<KnownCheck> known;      ///< in the order of the catalogue
  std::vector<GapShare> where;
  /// What is known beforehand (`knownId`), where anything is, then one for each cause, a gross_error first.
  std::vector<GapStep> steps;
  /// `afterwards`: with the causes found, and nothing besides.
  std::optional<IntersectionEstimate> before, afterwards;
  /// With whatever else may be there: the result of the measurement.
  std::optional<MeasuredIntersection> measured;
  std::vector<ClosureStep> closures;
  Unexplained unexplained;
  std::vector<UndetectableEffect> undetectable;     ///< the most dangerous first
  std::vector<UndetectableJump> undetectableJumps;  ///< in the order of the positions
  /// With a reference that has a σ: of the effects that these readings do not exclude at that size, the most
  /// plausible first.
  std::vector<Required> whatItWouldTake;
  std::vector<Advice> advice;  ///< the most telling first
  /// Where it was asked for: first with nothing more (`attainableUncertainties`). Empty with NotInCatalogue.
  std::vector<AttainableUncertainty> attainable;
  std::optional<GapShape> shape;              ///< with NotInCatalogue
  std::vector<FoundForm> forms;               ///< with NotInCatalogue; empty where none beats the pattern
  std::vector<double> leftBefore, leftAfter;  ///< residuals/σ before and after, in the order of `readings`
  std::vector<ReadingDeviation> readings;     ///< all that took part, `size` their residual before
};

/// A closure fails, and what was found does not account for it.
bool isMisclosed(const Diagnosis& diagnosis);

struct DiagnosisOptions {
  /// Ids of effects that are not considered.
  std::vector<std::string> without = {};
  /// The reference intersection is evidence for the causes, where it is stated with its σ. It never is for
  /// `Diagnosis::afterwards`.
  bool withReference = false;
  /// `Diagnosis::attainable` is worked out, which takes two thirds as long as all the rest.
  bool withAttainable = false;
  /// Only what a verdict is decided by (`decideAcceptance`), in half the time: causes, `measured`, closures,
  /// `unexplained` and `undetectableJumps`.
  bool forVerdict = false;
};

/// What `Diagnosis::afterwards` holds beyond the fit with the causes.
enum class Beyond {
  Nothing,
  Pattern,     ///< what the pattern may move Δd by
  LookAlikes,  ///< the average over what looks alike
  Others,      ///< the average over what else may be
};

Beyond beyondTheFit(const Diagnosis& diagnosis);

}  // namespace alidade
