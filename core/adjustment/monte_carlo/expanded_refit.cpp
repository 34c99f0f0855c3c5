#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/adjustment/joint/joint_problem.h"
#include "core/adjustment/monte_carlo/refit.h"
#include "core/base/eight.h"

// The forward model about a fit, to second order: of each reading, in units of its σ,
//
//   F(δ) = F(0) + J δ + ½ δᵀ H δ, δ = changes of (x, y, R, slider's zero, L, φ, error terms)
//
// J is from automatic differentiation, H from differences of J. Drawn noise enters as w = change of the
// reading, and L is drawn itself. The adjustment is repeated by steps with the unchanged normal equations of
// the fit,
//
//   δ ← δ + N⁻¹ [(J + H δ)ᵀ (r + w − J δ − ½ δᵀ H δ) − prior terms],
//
// with arc angles eliminated visit by visit. The first step is the linear propagation, the second includes
// the second order; further steps follow until they are negligible. Eight draws are processed together.

namespace alidade {

using Eigen::Index;

namespace {

/// The slots of a visit: slider's zero, x, y, R, L, φ, the pointing zeros if they are estimated, then the
/// error terms. The slider reading is linear in its zero, the one slot without second derivatives.
constexpr std::size_t fixedSlots = 6, zeroSlots = 2,
                      mostSlotsOfVisit = fixedSlots + zeroSlots + errorTermCount;
constexpr std::size_t sliderAt = 0, centreAt = 1, distanceAt = 4, phiAt = 5;

/// Returns, for each slot of a visit, the corresponding slot of `JointProblem`.
std::vector<Index> slotsWith(bool zeros, std::size_t terms) {
  using enum Unknown::Kind;
  std::vector<Index> slots;
  for (const auto kind : {SliderZero, CentreX, CentreY, Radius}) slots.push_back(static_cast<Index>(kind));
  slots.insert(slots.end(), {distanceSlot, phiSlot});
  if (zeros)
    for (const auto kind : {HorizontalZero, VerticalZero}) slots.push_back(static_cast<Index>(kind));
  for (std::size_t t = 0; t < terms; ++t) slots.push_back(static_cast<Index>(firstTermSlot + t));
  return slots;
}

struct ReadingRow {
  std::size_t noise = 0;            ///< index of its noise in a draw
  std::optional<std::size_t> zero;  ///< index of its pointing zero
  double perZero = 0;               ///< effect of 1 σ of the zero, in σ of the reading
  double left = 0;                  ///< residual of the fit, σ
  std::size_t first = 0;            ///< start of J, followed by H
};

struct VisitBlock {
  std::size_t arc = 0, firstRow = 0, rows = 0;
  std::size_t first = 0;  ///< start of JᵀJ_φ
  double perAngle = 0;    ///< 1/|J_φ|²
};

}  // namespace

class ExpandedModel {
 public:
  ExpandedModel(const RefitTask& task, const JointProblem& problem, const JointState& state)
      : m_firstTerm(fixedSlots +
                    (std::ranges::any_of(problem.estimated(), &Unknown::isPointingZero) ? zeroSlots : 0)),
        m_slots(slotsWith(m_firstTerm > fixedSlots, task.plan.terms())),
        m_state(state) {
    mapUnknowns(task, problem);
    addVisits(task, problem);
    addSecondDerivatives(task, problem);
    for (const VisitBlock& visit : m_visits) addMixed(visit);
  }

  std::size_t slots() const { return m_slots.size(); }
  std::size_t unknowns() const { return m_priorWeights.size(); }
  const std::vector<VisitBlock>& visits() const { return m_visits; }
  const std::vector<ReadingRow>& rows() const { return m_rows; }
  /// The estimated unknown of each slot of an arc; −1 for L and φ, and for an absent slider.
  const std::vector<int>& unknownsOf(std::size_t arc) const { return m_unknowns[arc]; }
  const double* numbers(std::size_t first) const { return &m_numbers[first]; }
  /// 1/σ² of the prior of an unknown, and the fitted value minus the prior value.
  double priorWeight(std::size_t unknown) const { return m_priorWeights[unknown]; }
  double beyondPrior(std::size_t unknown) const { return m_state.unknowns[static_cast<Index>(unknown)]; }

 private:
  void mapUnknowns(const RefitTask& task, const JointProblem& problem) {
    const auto slotOf = [&](const Unknown& unknown) {
      if (unknown.kind == Unknown::Kind::SliderZero) return sliderAt;
      if (unknown.kind == Unknown::Kind::HorizontalZero) return fixedSlots;
      if (unknown.kind == Unknown::Kind::VerticalZero) return fixedSlots + 1;
      return centreAt + static_cast<std::size_t>(unknown.kind);  // x, y, R
    };
    m_unknowns.assign(task.fitted.arcs.size(), std::vector<int>(slots(), -1));
    for (std::size_t arc = 0; arc < m_unknowns.size(); ++arc) {
      std::size_t term = m_firstTerm;
      for (std::size_t i = 0; i < problem.estimated().size(); ++i) {
        const Unknown& unknown = problem.estimated()[i];
        if (unknown.kind == Unknown::Kind::Error)
          m_unknowns[arc][term++] = static_cast<int>(i);
        else if (unknown.concerns(arc, problem.firsts()))
          m_unknowns[arc][slotOf(unknown)] = static_cast<int>(i);
      }
    }
    for (std::size_t i = 0; i < problem.estimated().size(); ++i)
      m_priorWeights.push_back(problem.prior(i).weight());
    const auto distance = std::ranges::find(problem.considered(), Unknown{.kind = Unknown::Kind::Distance});
    m_distanceIndex =
        static_cast<Index>(problem.estimated().size()) + (distance - problem.considered().begin());
  }

  void addVisits(const RefitTask& task, const JointProblem& problem) {
    const std::vector<VisitEquations> all = problem.equationsOf(m_state);
    const Measurement& read = task.fitted;
    for (std::size_t v = 0; v < all.size(); ++v) {
      const std::size_t arc = problem.visits()[v].arc;
      VisitBlock& visit = m_visits.emplace_back();
      visit.arc = arc;
      const std::array zeroSigmas{read.sigmaOfZeroHorizontal(read.arcs[arc]),
                                  read.sigmaOfZeroVertical(read.arcs[arc])};
      visit.firstRow = m_rows.size();
      visit.rows = static_cast<std::size_t>(all[v].residual.size());
      for (Index row = 0; row < all[v].residual.size(); ++row) {
        const ReadingRef cell = problem.cellOf(v, row);
        const auto kind = static_cast<std::size_t>(cell.kind);
        ReadingRow reading;
        reading.noise = task.plan.readings(arc, cell.sighting) + kind;
        if (cell.kind != ReadingKind::Slider) {
          // A zero read too large on the horizontal circle decreases the readings. A positive draw for
          // the vertical circle increases e, which means a lower zero.
          const bool isHorizontal = cell.kind == ReadingKind::Horizontal;
          const auto slot =
              static_cast<Index>(isHorizontal ? Unknown::Kind::HorizontalZero : Unknown::Kind::VerticalZero);
          reading.zero = task.plan.zeros(arc) + kind;
          reading.perZero = (isHorizontal ? -1 : 1) * all[v].jacobian(row, slot) * zeroSigmas[kind].radians();
        }
        reading.left = all[v].residual[row];
        reading.first = m_numbers.size();
        for (const Index slot : m_slots) m_numbers.push_back(all[v].jacobian(row, slot));
        m_numbers.resize(m_numbers.size() + slots() * slots());
        m_rows.push_back(reading);
      }
    }
  }

  /// A step that is visible in the digits of J but short compared with the scale on which J changes.
  double stepOf(const RefitTask& task, std::size_t slot) const {
    constexpr double length = 0.1, angle = 1e-4;  // mm, rad
    if (slot == phiAt) return angle;
    if (slot < fixedSlots) return length;
    if (slot < m_firstTerm) return angle;
    return estimatedTerms(task.fitted)[slot - m_firstTerm].priorSigma;
  }

  void addSecondDerivatives(const RefitTask& task, const JointProblem& problem) {
    for (std::size_t slot = centreAt; slot < slots(); ++slot) {
      const double step = stepOf(task, slot);
      // A circle's coordinate is a separate unknown for each arc; all are moved at once, as arcs are
      // independent.
      JointState above = m_state, below = m_state;
      const auto move = [&](JointState& state, double by) {
        if (slot == phiAt) {
          state.arcAngles.array() += by;
        } else if (slot == distanceAt) {
          state.unknowns[m_distanceIndex] += by;
        } else {
          std::vector<int> moved;
          for (const std::vector<int>& unknowns : m_unknowns)
            if (std::ranges::find(moved, unknowns[slot]) == moved.end()) {
              state.unknowns[unknowns[slot]] += by;
              moved.push_back(unknowns[slot]);
            }
        }
      };
      move(above, step);
      move(below, -step);
      takeDifferences(problem.equationsOf(above), problem.equationsOf(below), slot, 2 * step);
    }
  }

  void takeDifferences(const std::vector<VisitEquations>& above, const std::vector<VisitEquations>& below,
                       std::size_t slot, double apart) {
    for (std::size_t v = 0; v < m_visits.size(); ++v)
      for (std::size_t row = 0; row < m_visits[v].rows; ++row) {
        double* second = &m_numbers[m_rows[m_visits[v].firstRow + row].first + slots()];
        for (std::size_t i = 0; i < slots(); ++i) {
          const auto difference = above[v].jacobian(static_cast<Index>(row), m_slots[i]) -
                                  below[v].jacobian(static_cast<Index>(row), m_slots[i]);
          second[i * slots() + slot] += difference / apart / 2;  // half of the difference in each of the
                                                                 // two symmetric entries
          second[slot * slots() + i] += difference / apart / 2;
        }
      }
  }

  void addMixed(const VisitBlock& block) {
    VisitBlock& visit = m_visits[static_cast<std::size_t>(&block - m_visits.data())];
    visit.first = m_numbers.size();
    m_numbers.resize(m_numbers.size() + slots());
    double* mixed = &m_numbers[visit.first];
    for (std::size_t row = visit.firstRow; row < visit.firstRow + visit.rows; ++row) {
      const double* first = &m_numbers[m_rows[row].first];
      for (std::size_t i = 0; i < slots(); ++i) mixed[i] += first[i] * first[phiAt];
    }
    visit.perAngle = 1 / mixed[phiAt];
  }

  std::size_t m_firstTerm;
  std::vector<Index> m_slots;
  JointState m_state;
  std::vector<std::vector<int>> m_unknowns;
  std::vector<double> m_priorWeights;
  Index m_distanceIndex = 0;
  std::vector<VisitBlock> m_visits;
  std::vector<ReadingRow> m_rows;
  std::vector<double> m_numbers;
};

namespace {

/// Adds (J + Hδ)ᵀ v of one visit over its slots, where v are its residuals at δ. In the first step δ contains
/// only L, and H is omitted.
ALIDADE_WIDE void addGradient(const ExpandedModel& model, const VisitBlock& visit, const EightKept* normals,
                              const EightKept& scale, const EightKept* delta, bool isFirst,
                              EightKept* gradient) {
  const std::size_t slots = model.slots();
  Eight slopes[mostSlotsOfVisit];
  for (std::size_t r = visit.firstRow; r < visit.firstRow + visit.rows; ++r) {
    const ReadingRow& row = model.rows()[r];
    const double *first = model.numbers(row.first), *second = first + slots;
    Eight left =
        row.left + scale.at * normals[row.noise].at + row.perZero * normals[row.zero.value_or(row.noise)].at;
    if (isFirst) {
      left -= first[distanceAt] * delta[distanceAt].at;
      for (std::size_t i = 0; i < slots; ++i) gradient[i].at += first[i] * left;
      continue;
    }
    slopes[sliderAt] = Eight{} + first[sliderAt];
    left -= first[sliderAt] * delta[sliderAt].at;
    for (std::size_t i = centreAt; i < slots; ++i) {
      Eight bend{};
      for (std::size_t k = centreAt; k < slots; ++k) bend += second[i * slots + k] * delta[k].at;
      slopes[i] = first[i] + bend;
      left -= (first[i] + 0.5 * bend) * delta[i].at;
    }
    for (std::size_t i = 0; i < slots; ++i) gradient[i].at += slopes[i] * left;
  }
}

class ExpandedRefit : public Refit {
 public:
  ExpandedRefit(const RefitTask& task, std::shared_ptr<const ExpandedModel> model)
      : m_task(task),
        m_terms(estimatedTerms(task.fitted)),
        m_model(std::move(model)),
        m_unknowns(m_model->unknowns()),
        m_angles(m_model->visits().size()),
        m_pulls(m_angles.size()),
        m_priors(m_unknowns.size()),
        m_gradient(m_unknowns.size()) {}

  void refit(std::span<const Draw> draws, std::span<double> centres) override {
    for (std::size_t first = 0; first < draws.size(); first += eight) {
      const std::size_t count = std::min(eight, draws.size() - first);
      take(draws.subspan(first, count));
      constexpr int mostSteps = 6;
      for (int i = 0; i < mostSteps && step(i == 0); ++i) {
      }
      for (std::size_t l = 0; l < count; ++l) answer(&centres[(first + l) * m_task.centres()], l);
    }
  }

 private:
  /// If there are fewer draws than lanes, the first draw fills the remaining lanes.
  void take(std::span<const Draw> draws) {
    m_normals.resize(draws.front().normals.size());
    for (std::size_t l = 0; l < eight; ++l) {
      const Draw& draw = draws[l < draws.size() ? l : 0];
      m_scale.at[l] = draw.scale;
      for (std::size_t i = 0; i < m_normals.size(); ++i) m_normals[i].at[l] = draw.normals[i];
      for (std::size_t arc = 0; arc < m_task.fitted.arcs.size(); ++arc)
        for (const std::size_t zero : {m_task.plan.zeros(arc), m_task.plan.zeros(arc) + 1})
          m_normals[zero].at[l] *= draw.zeroScale;
      m_distance.at[l] = m_task.fitted.sigmaDistance * draw.normals[DrawPlan::distance];
    }
    std::ranges::fill(m_unknowns, EightKept{});
    std::ranges::fill(m_angles, EightKept{});
    takePriors();
  }

  /// The drawn values of the priors, relative to the fit.
  void takePriors() {
    const JointFit& joint = m_task.fit.joint;
    for (std::size_t i = 0; i < m_priors.size(); ++i) {
      const Unknown& unknown = joint.unknowns[i];
      const auto term = std::ranges::find(m_terms, unknown.term, &EstimatedTerm::term);
      const bool isTerm = unknown.kind == Unknown::Kind::Error && term != m_terms.end();
      Eight drawn{};
      if (isTerm)
        drawn = term->priorSigma *
                m_normals[DrawPlan::firstTerm + static_cast<std::size_t>(term - m_terms.begin())].at;
      else if (unknown.kind == Unknown::Kind::Radius && m_model->priorWeight(i) > 0)
        drawn = m_task.fitted.sigmaRadius * m_normals[DrawPlan::radius].at;
      m_priors[i].at = drawn - m_model->beyondPrior(i);
    }
  }

  /// False if the change is negligible.
  bool step(bool isFirst) {
    for (std::size_t i = 0; i < m_gradient.size(); ++i)
      m_gradient[i].at = m_model->priorWeight(i) * (m_priors[i].at - m_unknowns[i].at);
    for (std::size_t v = 0; v < m_angles.size(); ++v) gather(v, isFirst);
    const bool moved = solve();
    for (std::size_t v = 0; v < m_angles.size(); ++v) follow(v);
    return moved;
  }

  void gather(std::size_t v, bool isFirst) {
    const VisitBlock& visit = m_model->visits()[v];
    const std::vector<int>& unknowns = m_model->unknownsOf(visit.arc);
    std::array<EightKept, mostSlotsOfVisit> delta, gradient;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      delta[i] = unknowns[i] < 0 ? EightKept{} : m_unknowns[static_cast<std::size_t>(unknowns[i])];
      gradient[i] = EightKept{};
    }
    delta[distanceAt] = m_distance;
    delta[phiAt] = m_angles[v];
    addGradient(*m_model, visit, m_normals.data(), m_scale, delta.data(), isFirst, gradient.data());
    m_pulls[v] = gradient[phiAt];
    const double* mixed = m_model->numbers(visit.first);
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      if (unknowns[i] < 0) continue;
      m_gradient[static_cast<std::size_t>(unknowns[i])].at +=
          gradient[i].at - mixed[i] * visit.perAngle * m_pulls[v].at;
    }
  }

  bool solve() {
    constexpr double little = 0.01;  // σ: steps shrink by a constant ratio, so the next one is negligible
    const SquareMatrix& cofactor = m_task.fit.joint.cofactor;
    m_step.assign(m_unknowns.size(), EightKept{});
    bool moved = false;
    for (std::size_t i = 0; i < m_unknowns.size(); ++i) {
      for (std::size_t k = 0; k < m_unknowns.size(); ++k) m_step[i].at += cofactor(i, k) * m_gradient[k].at;
      m_unknowns[i].at += m_step[i].at;
      const double enough = little * std::sqrt(cofactor(i, i));
      for (std::size_t l = 0; l < eight; ++l) moved = moved || std::abs(m_step[i].at[l]) > enough;
    }
    return moved;
  }

  void follow(std::size_t v) {
    const VisitBlock& visit = m_model->visits()[v];
    const std::vector<int>& unknowns = m_model->unknownsOf(visit.arc);
    const double* mixed = m_model->numbers(visit.first);
    Eight left = m_pulls[v].at;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      if (unknowns[i] >= 0) left -= mixed[i] * m_step[static_cast<std::size_t>(unknowns[i])].at;
    m_angles[v].at += visit.perAngle * left;
  }

  void answer(double* centres, std::size_t lane) const {
    const JointFit& joint = m_task.fit.joint;
    for (std::size_t arc = 0; arc < m_task.fitted.arcs.size(); ++arc) {
      const std::vector<int>& unknowns = m_model->unknownsOf(arc);
      for (std::size_t i = 0; i < 2; ++i) {
        const auto unknown = static_cast<std::size_t>(unknowns[centreAt + i]);
        centres[2 * arc + i] = joint.values[unknown] + m_unknowns[unknown].at[lane];
      }
    }
  }

  RefitTask m_task;
  std::vector<EstimatedTerm> m_terms;
  std::shared_ptr<const ExpandedModel> m_model;
  std::vector<EightKept> m_normals;
  EightKept m_scale, m_distance;
  std::vector<EightKept> m_unknowns, m_angles, m_pulls, m_priors, m_gradient, m_step;
};

}  // namespace

std::shared_ptr<const ExpandedModel> expandedModel(const RefitTask& task) {
  constexpr std::size_t mostNumbers = 8'000'000;  // 64 MB
  const std::size_t slots = mostSlotsOfVisit - errorTermCount + task.plan.terms();
  if (task.fit.joint.readings.size() * slots * (slots + 1) > mostNumbers) return nullptr;
  const JointProblem problem(task.fitted, {.terms = estimatedTerms(task.fitted)});
  return std::make_shared<const ExpandedModel>(task, problem, problem.stateOf(task.fit.joint));
}

std::unique_ptr<Refit> expandedRefit(const RefitTask& task, std::shared_ptr<const ExpandedModel> model) {
  return std::make_unique<ExpandedRefit>(task, std::move(model));
}

}  // namespace alidade
