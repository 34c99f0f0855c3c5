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

// The situation: arcs at one or two rotations of the axis were sighted from one stand, some repeatedly.
// Rounds, faces, slider readings and missing points are mixed in any way. Both circles and the slider of each
// row are observations of the one forward model (observe.h), and one least squares adjustment of all of them,
//
//   minimise Σ (reading − model(unknowns))²/σ²,
//
// finds centre and radius of each arc, the zero of its slider, the requested error terms, and one arc angle
// for each visit, which its faces share. Gauss-Newton with Levenberg's damping; the arc angles are eliminated
// visit by visit, so the equations stay small for any number of points. Derivatives are automatic.
//
// The arcs of one axis share centre and radius. Values of a single arc have its index, shared values that of
// the first arc sharing them (`firstAtTheirAxes`).
//
// The pointing zeros and the distance are also observed, but the readings contain next to no information on
// them. They keep the values read, and their σ are propagated to the result ("considered"), so that readings
// which scatter more than stated cannot shift a zero. If an axis is measured again its zeros contradict each
// other; then all zeros are estimated, with their stated σ as priors.

/// The kind of an unknown of the adjustment.
struct Unknown {
  enum class Kind { CentreX, CentreY, Radius, HorizontalZero, VerticalZero, SliderZero, Distance, Error };

  /// `arc` of a radius or x shared by the arcs of both axes, and of a zero common to all arcs.
  static constexpr std::size_t everyArc = static_cast<std::size_t>(-1);

  Kind kind = Kind::CentreX;
  std::size_t arc = 0;                      ///< index into the measurement's arcs; 0 for Distance and Error
  ErrorTerm term = ErrorTerm::Collimation;  ///< of an Error

  /// Does the unknown belong to the guideway at one axis angle, so that repeated arcs share it?
  bool isOfAxis() const { return kind == Kind::CentreX || kind == Kind::CentreY || kind == Kind::Radius; }
  bool isPointingZero() const { return kind == Kind::HorizontalZero || kind == Kind::VerticalZero; }
  /// Does a reading of arc `index` depend on the unknown? `firsts`: as `JointFit::firsts`.
  bool concerns(std::size_t index, const std::vector<std::size_t>& firsts) const {
    return kind == Kind::Distance || kind == Kind::Error || arc == everyArc ||
           arc == (isOfAxis() ? firsts[index] : index);
  }

  bool operator==(const Unknown&) const = default;
};

/// An error term to be estimated. In the unit of the term: rad, mm or 1.
struct EstimatedTerm {
  ErrorTerm term;
  double priorSigma;  ///< plausible size; infinite: no prior knowledge
  double priorValue = 0;
  double start = 0;  ///< start value of the fit

  Prior prior() const { return {priorValue, priorSigma}; }
};

/// One reading after the adjustment.
struct AdjustedReading {
  std::size_t arc = 0;       ///< index into the measurement's arcs
  std::size_t sighting = 0;  ///< index into the arc's sightings; for a slider reading, that of its row
  ReadingKind kind = ReadingKind::Horizontal;
  std::uint32_t visit = 0;  ///< number among the visits of its arc
  double residual = 0;      ///< observed minus adjusted, rad; up positive for the vertical circle
  double sigma = 0;         ///< stated, rad
  double redundancy = 0;    ///< share of an error of this reading that shows in its own residual, 0…1
  double perReading = 0;    ///< ∂Δd/∂reading, mm per rad; 0 without an intersection

  /// Does another reading check this one? If so, the redundancy exceeds rounding error.
  bool isChecked() const { return redundancy >= 1e-9; }
  /// The standardised residual w = v/(s0 σ √r), with s0 = `scale` > 0; its variance is 1 for a sound reading
  /// (Baarda 1968). NaN if no other reading checks this one.
  double standardised(double scale) const {
    return isChecked() ? residual / (scale * sigma * std::sqrt(redundancy))
                       : std::numeric_limits<double>::quiet_NaN();
  }
};

/// The residuals of one arc, summed.
struct ArcResidualSum {
  double chiSquare = 0;  ///< Σ (v/σ)² over circles and slider
  /// Σ r over the same readings: the expectation of χ² if the stated σ are right. For an arc that shares no
  /// unknown with others it is readings − visits − unknowns; a shared unknown counts in part for each arc.
  double degreesOfFreedom = 0;
};

struct JointFitOptions {
  /// Each term at most once.
  std::vector<EstimatedTerm> terms = {};
  /// `Sighting::order` of the first row after the orientation jumped; the terms of a jump act from there on.
  std::optional<std::size_t> jumpBefore = {};
  /// `Sighting::order` of the first row whose zero was sighted after the jump; the jump acts only before it.
  std::optional<std::size_t> jumpEnd = {};
  /// The model of one rigid guideway turned about an axis along x, in place of the measurement's own radius
  /// model. Both positions share one radius and one x. The pointing zeros are estimated with their stated σ
  /// as priors, since a wrong zero leaves residuals in this model.
  bool isClosed = false;
  /// Each arc has its own centre and radius, even at the same axis angle, and uses its pointing zero as read,
  /// to show how the arcs disagree. Not together with `isClosed`.
  bool isApart = false;
  /// The pointing zeros are estimated even if no axis is measured again: for a part of a session whose fit
  /// estimates them.
  bool estimatesZeros = false;
  /// Excluded readings: they get no weight, a residual of 0 and a redundancy of 0. The slider reading of a
  /// visit is that of its first row which has one.
  std::vector<ReadingRef> without = {};
  int maximumIterations = 60;
  /// Converged if the next step is shorter than this many standard deviations of the result.
  double tolerance = 1e-9;
};

struct JointFit {
  std::vector<Unknown> unknowns;    ///< estimated
  std::vector<double> values;       ///< of the unknowns: mm, rad, or the unit of the term
  std::vector<std::size_t> firsts;  ///< for each arc, the arc whose centre and radius it shares
  /// Prior σ of each unknown, such as of a known radius or a zero of a closed model; infinite without prior
  /// knowledge.
  std::vector<double> priorSigmas;
  /// Covariance of the unknowns, only from the stated σ of circles and slider and from the priors.
  SquareMatrix cofactor;
  /// The cofactor with the error terms fixed; equal to `cofactor` without terms.
  SquareMatrix cofactorWithoutTerms;

  bool zerosAreReadings = false;         ///< as `Measurement::zerosAreReadings`
  double zeroScatter = 1;                ///< as in the measurement, whose σ of zeros already include it
  std::vector<Unknown> considered;       ///< zeros and distance
  std::vector<double> consideredSigmas;  ///< rad, mm; may be 0
  /// ∂unknown/∂considered, unknowns × considered, row by row.
  std::vector<double> perConsidered;

  /// For each reading of a pointing zero that is an observation: ∂reading/∂unknowns, divided by its σ.
  std::vector<std::vector<double>> zeroRows = {};
  /// φ of each sighting of each arc, rad: `unwrappedArcAngle`, or `unwrapAlongSlider` if the slider is read.
  std::vector<std::vector<double>> arcAngles;
  std::vector<AdjustedReading> readings;     ///< visit by visit
  std::vector<ArcResidualSum> residualSums;  ///< of each arc of the measurement
  double chiSquare = 0;                      ///< of circles, slider and priors
  int degreesOfFreedom = 0;
  int iterations = 0;
  /// `Undetermined` if a number of the fit is not finite or a variance is negative. Also if the fit did not
  /// converge and the σ of a centre or radius exceeds the smallest radius.
  FitStatus status = FitStatus::Undetermined;

  /// Index of an unknown; `unknowns.size()` if this fit lacks it. For a shared centre or radius, `arc` may be
  /// any arc that shares it.
  std::size_t indexOf(const Unknown& unknown) const;
  std::size_t indexOf(ErrorTerm term) const {
    return indexOf(Unknown{.kind = Unknown::Kind::Error, .arc = 0, .term = term});
  }
  bool converged() const { return status == FitStatus::Converged; }
  /// If false, `chiSquare`, `values` and all results derived from them are meaningless.
  bool isDetermined() const { return status != FitStatus::Undetermined; }
  /// Returns the circle of an arc of the measurement.
  Circle circleOf(std::size_t arc) const;
};

/// Starts from `starts`, one circle for each arc of the measurement. `status` says whether the fit found the
/// minimum, or why not.
JointFit fitJointly(const Measurement& measurement, const std::vector<Circle>& starts,
                    const JointFitOptions& options = {});

}  // namespace alidade
