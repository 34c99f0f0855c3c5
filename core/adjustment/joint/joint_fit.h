#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/adjustment/numerics/fit_status.h"
#include "core/adjustment/numerics/prior.h"
#include "core/adjustment/numerics/square_matrix.h"
#include "core/observation/error_term.h"
#include "core/observation/guideway.h"
#include "core/observation/reading_ref.h"
#include "core/session/measurement.h"

namespace alidade {

// The situation: arcs at one or two rotations of the axis, some of them measured again, were sighted from one
// stand, in any mixture of rounds, faces, slider readings and missing points. Both circles and the slider of
// each row are observations of the one forward model (observe.h), and one least squares adjustment of all of
// them,
//
//   minimise Σ (reading − model(unknowns))²/σ²,
//
// finds centre and radius of each arc, the zero of its slider, the error terms asked for, and one arc angle
// for each visit, which its faces share. Gauss-Newton with Levenberg's damping; the arc angles are eliminated
// visit by visit, so the equations stay small however many points there are. Derivatives are automatic.
//
// The arcs of one axis share centre and radius. What is of one arc alone stands under its index, what arcs
// share under that of the first of them (`firstAtTheirAxes`).
//
// The pointing zeros and the distance are observed as well, but the readings say next to nothing about them:
// they keep the values read, and their σ are carried through to the result ("considered"), so that readings
// which scatter more than stated cannot pull a zero along. Where an axis is measured again its zeros
// contradict each other; then all zeros are estimated, as well known as stated.

/// What an unknown of the adjustment is.
struct Unknown {
  enum class Kind { CentreX, CentreY, Radius, HorizontalZero, VerticalZero, SliderZero, Distance, Error };

  /// `arc` of a radius or x that the arcs of both axes share, and of a zero that all arcs have.
  static constexpr std::size_t everyArc = static_cast<std::size_t>(-1);

  Kind kind = Kind::CentreX;
  std::size_t arc = 0;                      ///< index into the measurement's arcs; 0 for Distance and Error
  ErrorTerm term = ErrorTerm::Collimation;  ///< of an Error

  /// Of the guideway at one rotation of the axis, whichever arc is sighted there.
  bool isOfAxis() const { return kind == Kind::CentreX || kind == Kind::CentreY || kind == Kind::Radius; }
  bool isPointingZero() const { return kind == Kind::HorizontalZero || kind == Kind::VerticalZero; }
  /// One of the readings of arc `index` hangs on it; `firsts`: of each arc the one it shares centre and
  /// radius with.
  bool concerns(std::size_t index, const std::vector<std::size_t>& firsts) const {
    return kind == Kind::Distance || kind == Kind::Error || arc == everyArc ||
           arc == (isOfAxis() ? firsts[index] : index);
  }

  bool operator==(const Unknown&) const = default;
};

/// An error term to be estimated along. In the unit of the term: rad, mm or 1.
struct EstimatedTerm {
  ErrorTerm term;
  double priorSigma;  ///< plausible size; infinite: nothing is known beforehand
  double priorValue = 0;
  double start = 0;  ///< where the fit begins

  Prior prior() const { return {priorValue, priorSigma}; }
};

/// One reading after the adjustment.
struct AdjustedReading {
  std::size_t arc = 0;       ///< index into the measurement's arcs
  std::size_t sighting = 0;  ///< index into the arc's sightings; of a slider reading the row it stands in
  ReadingKind kind = ReadingKind::Horizontal;
  std::uint32_t visit = 0;  ///< number among the visits of its arc
  double residual = 0;      ///< observed minus adjusted, rad; up positive for the vertical circle
  double sigma = 0;         ///< stated, rad
  double redundancy = 0;    ///< share of an error of this reading that shows in its own residual, 0…1
  double perReading = 0;    ///< ∂Δd/∂reading, mm per rad; 0 without an intersection

  /// Another reading checks it: its redundancy is more than the rounding of one of 0.
  bool isChecked() const { return redundancy >= 1e-9; }
  /// The standardised residual w = v/(s0 σ √r) at noise `scale` times (s0 > 0) the stated one: of variance 1
  /// where the reading is sound (Baarda 1968). NaN where nothing checks the reading.
  double standardised(double scale) const {
    return isChecked() ? residual / (scale * sigma * std::sqrt(redundancy))
                       : std::numeric_limits<double>::quiet_NaN();
  }
};

/// What the readings of one arc leave over.
struct ArcMisfit {
  double chiSquare = 0;      ///< Σ (v/σ)² over circles and slider
  int degreesOfFreedom = 0;  ///< readings − visits − unknowns of the arc alone, that have no prior
};

struct JointFitOptions {
  /// Each term at most once.
  std::vector<EstimatedTerm> terms = {};
  /// `Sighting::order` of the first row after the orientation jumped; the terms of a jump act from there.
  std::optional<std::size_t> jumpBefore = {};
  /// Of the first row on which they act no longer, since its zero was sighted after the jump; absent: on all.
  std::optional<std::size_t> jumpEnd = {};
  /// As one rigid guideway turned about an axis along x has it, whatever the measurement's own model of the
  /// radius: one radius and one x for both positions, and the pointing zeros estimated, as well known as
  /// stated, since a wrong one leaves residuals then.
  bool isClosed = false;
  /// Each arc has a centre and a radius of its own, those of one axis, too, and keeps the zero read: to see
  /// what they disagree by. Not of a closed one.
  bool isApart = false;
  /// The pointing zeros are estimated although nothing contradicts them: of a part of a session in which they
  /// are.
  bool estimatesZeros = false;
  /// Readings that take no part: they get no weight, a residual of 0 and a redundancy of 0. The slider
  /// reading of a visit is that of its first row which has one.
  std::vector<ReadingRef> without = {};
  int maximumIterations = 60;
  /// Converged when the next step is shorter than this many standard deviations of the result.
  double tolerance = 1e-9;
};

struct JointFit {
  std::vector<Unknown> unknowns;    ///< estimated
  std::vector<double> values;       ///< of the unknowns: mm, rad, or the unit of the term
  std::vector<std::size_t> firsts;  ///< of each arc the one whose centre and radius it has
  /// With which each unknown was known beforehand: such as a known radius, or a zero of a closed model;
  /// infinite where nothing is.
  std::vector<double> priorSigmas;
  /// Covariance of the unknowns from the stated σ of circles and slider, and the priors, alone.
  SquareMatrix cofactor;
  /// The same with the error terms taken as known; equal where there are none.
  SquareMatrix cofactorWithoutTerms;

  bool zerosAreReadings = false;         ///< of the measurement
  double zeroScatter = 1;                ///< of the measurement, and in the σ of its zeros
  std::vector<Unknown> considered;       ///< zeros and distance
  std::vector<double> consideredSigmas;  ///< rad, mm; may be 0
  /// ∂unknown/∂considered, unknowns × considered, row by row.
  std::vector<double> perConsidered;

  /// Of each reading of a pointing zero that is an observation: ∂reading/∂unknowns, over its σ.
  std::vector<std::vector<double>> zeroRows = {};
  /// φ of each sighting of each arc, rad in (−π, π]; where the slider is read, without a seam
  /// (`unwrapAlongSlider`).
  std::vector<std::vector<double>> arcAngles;
  std::vector<AdjustedReading> readings;  ///< visit by visit
  std::vector<ArcMisfit> misfits;         ///< of each arc of the measurement
  double chiSquare = 0;                   ///< of circles, slider and priors
  int degreesOfFreedom = 0;
  int iterations = 0;
  /// `Undetermined` where a number of the fit is not finite or a variance negative, and where it did not
  /// settle and a circle is less well known than it is large.
  FitStatus status = FitStatus::Undetermined;

  /// Index of an unknown; `unknowns.size()` where it is not one of this fit. Centre and radius of any arc are
  /// the shared ones where there are such.
  std::size_t indexOf(const Unknown& unknown) const;
  bool converged() const { return status == FitStatus::Converged; }
  /// Else `chiSquare`, `values` and whatever follows from them mean nothing.
  bool isDetermined() const { return status != FitStatus::Undetermined; }
  /// Of an arc of the measurement.
  Circle circleOf(std::size_t arc) const;
};

/// Starts from `starts`, one circle for each arc of the measurement. Whether it found the minimum, or
/// why not, is in `status`.
JointFit fitJointly(const Measurement& measurement, const std::vector<Circle>& starts,
                    const JointFitOptions& options = {});

}  // namespace alidade
