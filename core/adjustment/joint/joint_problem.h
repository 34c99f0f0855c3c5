#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"
#include "core/observation/observe.h"
#include "core/observation/visits.h"

namespace alidade {

// The equations behind `fitJointly`, visit by visit. Holds linear algebra types, so only .cpp files of
// `core/adjustment` include it.

/// The quantities on which one visit's readings depend: x, y, R, errors of both zeros, zero of the slider, L,
/// then φ, then the error terms.
inline constexpr int distanceSlot = 6, phiSlot = 7, firstTermSlot = 8;
inline constexpr int mostSlots = firstTermSlot + static_cast<int>(errorTermCount);

/// A vector with one entry for each slot of the fit, without heap allocation.
using Slots = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, mostSlots, 1>;

/// A square matrix over the slots.
using SlotMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, mostSlots, mostSlots>;

/// All readings of one visit, whitened: rows horizontal, vertical for each row of the session, then the
/// slider reading if there is one.
struct VisitEquations {
  static constexpr int mostRows = 5;  // two circles in two faces, and the slider
  /// Allocated on the heap: fixed memory for every slot would be mostly unused.
  using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, mostRows, 1> residual;
  Jacobian jacobian;
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, mostRows, 1> along;  ///< unit direction of ∂/∂φ
};

struct VisitOfArc {
  std::size_t arc = 0;
  Visit visit;
  const Sighting* slider = nullptr;  ///< the row whose slider reading represents the visit
};

struct JointState {
  /// Estimated unknowns minus their prior values (`Prior::value`), then considered ones, which stay zero.
  Eigen::VectorXd unknowns;
  Eigen::VectorXd arcAngles;  ///< of each visit
};

/// Normal equations with the arc angles eliminated, over all unknowns, and the equations they come from.
struct JointSystem {
  std::vector<VisitEquations> equations;  ///< of each visit
  Eigen::MatrixXd matrix;
  Eigen::VectorXd rightSide;
  double chiSquare = 0;
};

class JointProblem {
 public:
  JointProblem(const Measurement& measurement, const JointFitOptions& options);

  const std::vector<Unknown>& estimated() const { return m_estimated; }
  const std::vector<Unknown>& considered() const { return m_considered; }
  double consideredSigma(std::size_t i) const { return m_consideredSigmas[i]; }
  /// The prior of an estimated unknown. The state counts from the prior value, so that even a radius known to
  /// a nanometre survives rounding.
  const Prior& prior(std::size_t i) const { return m_priors[i]; }
  const std::vector<VisitOfArc>& visits() const { return m_visits; }
  /// For each arc, the arc whose centre and radius it shares.
  const std::vector<std::size_t>& firsts() const { return m_firsts; }

  JointState start(const std::vector<Circle>& circles) const;
  /// The solution of a fit of the same measurement; error terms that it lacks are zero.
  JointState stateOf(const JointFit& fit) const;
  /// The reading of a row of a visit's equations.
  ReadingRef cellOf(std::size_t visit, Eigen::Index row) const;
  VisitEquations equationsOf(const JointState& state, std::size_t visit) const;
  /// Returns the equations of every visit.
  std::vector<VisitEquations> equationsOf(const JointState& state) const;
  /// Calls `take` with the equations of each visit in turn; only the equations of one visit are in memory.
  void eachVisit(const JointState& state,
                 const std::function<void(std::size_t visit, const VisitEquations&)>& take) const;
  /// `used`: a discarded system whose memory the new one reuses.
  JointSystem system(const JointState& state, JointSystem used = {}) const;
  /// The state after a step of the estimated unknowns; each arc angle follows from its own equation.
  /// `equations`: those of `state`, for each visit.
  JointState moved(const JointState& state, const std::vector<VisitEquations>& equations,
                   const Eigen::VectorXd& step) const;

  /// A vector over an arc's slots, expanded to all unknowns.
  Eigen::VectorXd spread(const Slots& values, std::size_t arc) const;
  /// The part of a vector or matrix over the estimated unknowns that belongs to an arc's slots; 0 for the
  /// other slots.
  Slots gathered(const Eigen::VectorXd& values, std::size_t arc) const;
  SlotMatrix gathered(const Eigen::MatrixXd& values, std::size_t arc) const;
  /// The equations' derivatives with the arc angle eliminated: the component along ∂/∂φ is subtracted from
  /// every column.
  static VisitEquations::Jacobian reduced(const VisitEquations& equations);
  /// One row of the reduced derivatives.
  static Slots reduced(const VisitEquations& equations, Eigen::Index row);

 private:
  int slots() const { return firstTermSlot + static_cast<int>(m_terms.size()); }
  Eigen::Index count() const { return static_cast<Eigen::Index>(m_estimated.size() + m_considered.size()); }
  void addArc(std::size_t arc);
  void addZero(const Unknown& zero, double sigma);
  bool sharesRadius() const;
  /// The prior of a radius shared by both positions.
  Prior radiusPrior() const;
  /// The mean over the circles that share an unknown centre or radius.
  double meanOf(const Unknown& unknown, const std::vector<Circle>& circles) const;
  void estimate(const Unknown& unknown, const Prior& prior);
  void consider(const Unknown& unknown, double sigma);
  void buildSlotMaps();
  /// For each visit of an arc, the row with its slider reading, or null.
  using Sliders = std::span<const Sighting* const>;
  using TakeArc = std::function<void(std::size_t arc, std::span<double> arcAngles, Sliders sliders)>;
  void eachArc(JointState& state, const TakeArc& take) const;
  template <typename Function>
  auto withJets(const Function& function) const;
  template <typename Jets>
  Jets jetsOf(const JointState& state, std::size_t arc) const;
  template <typename Jets>
  void fillZeroEquations(const Jets& jets, std::size_t visit, VisitEquations& equations) const;
  template <typename Jets>
  void fillEquations(const Jets& jets, const JointState& state, std::size_t visit,
                     VisitEquations& equations) const;
  void fillEquations(const JointState& state, std::vector<VisitEquations>& equations) const;
  /// Calls `fill` for each visit, with the jets of the visit's arc.
  template <typename Fill>
  void withJetsOfEachVisit(const JointState& state, const Fill& fill) const;
  bool hasJumped(std::size_t order) const;
  Pointing zeroPointing(const ArcMeasurement& arc) const;
  Pointing pointingOf(const ArcMeasurement& arc, const Sighting& sighting) const;
  bool takesPart(std::size_t arc, std::size_t sighting, ReadingKind kind) const;

  const Measurement& m_measurement;
  std::vector<EstimatedTerm> m_terms;
  std::unique_ptr<OwnModel> m_own;  ///< null unless a term is of the user's own effects
  std::optional<std::size_t> m_jumpBefore, m_jumpEnd;
  bool m_isClosed;
  std::vector<std::size_t> m_firsts;
  bool m_estimatesZeros = false;
  std::vector<ReadingRef> m_without;
  std::vector<Unknown> m_estimated, m_considered;
  std::vector<Prior> m_priors;
  std::vector<double> m_consideredSigmas;
  std::vector<VisitOfArc> m_visits;
  std::vector<std::array<Eigen::Index, mostSlots>>
      m_slotMaps;  ///< for each arc: index of each slot's unknown, −1: none
};

}  // namespace alidade
