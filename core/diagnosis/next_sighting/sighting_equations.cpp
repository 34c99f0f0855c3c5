#include "core/diagnosis/next_sighting/sighting_equations.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/adjustment/joint/linearised.h"
#include "core/adjustment/result/intersection.h"
#include "core/diagnosis/candidates/candidates.h"
#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/candidates/gross_error_components.h"
#include "core/diagnosis/candidates/jump_components.h"
#include "core/diagnosis/forms/form_families.h"
#include "core/diagnosis/next_sighting/possible_forms.h"
#include "core/effects/cause_ids.h"
#include "core/effects/known_sizes.h"
#include "core/observation/half_turn.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// Prior σ of an unknown without prior knowledge: so wide that it only keeps the equations regular.
double widePrior(const Unknown& unknown) {
  constexpr double length = 10, direction = 0.01, slider = 0.1;  // mm, rad, rad
  if (unknown.isPointingZero()) return direction;
  return unknown.kind == Unknown::Kind::SliderZero ? slider : length;
}

bool isBent(const Effect& effect) {
  return effect.response == Response::Bent;
}

Linearised linearisedAt(const PossibleSightings& session, const std::vector<Circle>& circles,
                        const std::vector<ErrorTerm>& terms, const std::vector<EstimatedTerm>& at = {}) {
  Linearised all;
  linearise(session.measurement, circles, {.terms = at, .isClosed = true}, terms,
            [&](const Linearised& piece) { all = piece; });
  return all;
}

/// ∂reading/∂term of every reading, whitened, for `size` units of the term.
VectorXd columnOf(const Linearised& all, ErrorTerm term, double size) {
  return VectorXd::NullaryExpr(std::ssize(all.readings),
                               [&](Index i) { return all.ofTerm(static_cast<std::size_t>(i), term) * size; });
}

/// The second derivatives of every reading by the two numbers of a bent effect, in plausible sizes, from the
/// derivatives at a plausible size of either number. Source: forward differences.
MatrixXd secondDerivatives(const PossibleSightings& session, const std::vector<Circle>& circles,
                           const Linearised& all, const Effect& bent) {
  const EffectParameter &x = bent.parameters[0], &y = bent.parameters[1];
  const auto shiftedBy = [&](const EffectParameter& number) {
    constexpr double free = 1e6;  // rad: no prior knowledge
    return linearisedAt(session, circles, {x.term, y.term}, {{number.term, free, 0, plausibleSize(number)}});
  };
  const auto change = [&](const Linearised& from, const EffectParameter& of) -> VectorXd {
    return (columnOf(from, of.term, 1) - columnOf(all, of.term, 1)) * plausibleSize(of);
  };
  const Linearised byX = shiftedBy(x), byY = shiftedBy(y);
  MatrixXd columns(std::ssize(all.readings), 3);
  columns << change(byX, x), (change(byX, y) + change(byY, x)) / 2, change(byY, y);
  return columns;
}

/// The readings of a linearised session by visit, with columns for every unknown and hypothesis.
class Assembly {
 public:
  /// `all` is linearised at `circles`.
  Assembly(const PossibleSightings& session, const SightingPlan& plan, const std::vector<Circle>& circles,
           const Linearised& all)
      : m_session(session), m_plan(plan), m_circles(circles), m_all(all) {
    m_residual = overReadings([&](std::size_t i) { return m_all.readings[i].residual; });
    for (const std::size_t u : all.uncertainUnknowns()) addUnknown(u);
  }

  /// Adds the effects of the session's own model as unknowns, and the others as hypotheses.
  void addEffects() {
    const std::vector<const Effect*> effects = effectsOf(m_session.measurement);
    const auto isInModel = [&](const Effect* effect) {
      const std::vector<std::string>& model = m_session.measurement.effects;
      return std::ranges::find(model, effect->id) != model.end();
    };
    for (const Effect* effect : effects)
      if (isInModel(effect) && hasSizes(*effect))
        for (const EffectParameter& parameter : effect->parameters) addUnknown(parameter);
    for (const Effect* effect : effects)
      if (!isInModel(effect) && (m_plan.readsSlider || !needsSlider(*effect))) addEffect(*effect);
    m_result.effectColumns = m_causeColumns;
  }

  /// Adds forms, jumps, wrong zeros and gross errors. Rows still to be read keep their share of the prior
  /// odds of jumps and gross errors. The evidence of the mixture thus stays a martingale.
  void addFurther() {
    m_result.priorOdds += m_odds.jump + m_odds.wrongZero + m_odds.grossError + m_odds.noise + m_odds.shape;
    for (std::size_t i = 0; const MatrixXd& columns : columnsOfForms(m_session, m_circles, m_all))
      if (const double share = possibleForms()[i++].share; columns.cols() > 0)
        add(formId, columns, &formWidths(), m_odds.shape * share);
    std::set<std::size_t> orders;
    for (const LinearReading& reading : m_all.readings)
      if (isTaken(reading) && !reading.isZero) orders.insert(reading.sequence);
    const auto rows = static_cast<double>(std::max(m_plan.rows, orders.size()));
    for (const std::size_t order : orders)
      if (order != *orders.begin())
        addJump(m_odds.jump / rows, [=](const LinearReading& reading) { return reading.sequence >= order; });
    for (std::size_t arc = 0; arc < m_session.newArc; ++arc)
      addJump(std::ldexp(m_odds.wrongZero, -1 - static_cast<int>(arc)),
              [=](const LinearReading& reading) { return reading.arc == arc && !reading.isZero; });
    for (std::size_t i = 0; i < m_all.readings.size(); ++i)
      if (const LinearReading& reading = m_all.readings[i];
          isTaken(reading) && !reading.isZero && reading.kind != ReadingKind::Slider)
        add(grossErrorId, VectorXd::Unit(m_residual.size(), static_cast<Index>(i)), &grossErrorWidths(),
            m_odds.grossError / (2 * rows));
  }

  SightingEquations equations() {
    layOut();
    for (std::size_t first = 0; first < m_all.readings.size();) first = addVisit(first);
    m_taken.conservativeResize(m_takenRows, Eigen::NoChange);
    m_result.taken = splitUp(m_taken);
    m_result.residual = m_taken.rightCols(1);
    const MatrixXd zero = rowsOf(m_newZero);
    for (const auto& [place, rows] : m_possible) {
      const bool turns = place.first == m_session.newArc;
      MatrixXd all((turns ? zero.rows() : 0) + rows.rows(), rows.cols());
      if (turns) all.topRows(zero.rows()) = zero;
      all.bottomRows(rows.rows()) = rows;
      m_result.possible.push_back(splitUp(all));
    }
    return std::move(m_result);
  }

 private:
  const PossibleSightings& m_session;
  const SightingPlan& m_plan;
  const std::vector<Circle>& m_circles;
  const Linearised& m_all;
  const PriorOdds m_odds = {};
  SightingEquations m_result;
  std::vector<MatrixXd> m_columns;  ///< a row per reading; a matrix per unknown, then one per cause
  Index m_causeColumns = 0;
  VectorXd m_residual;                 ///< over the readings, without known values
  MatrixXd m_rows, m_taken;            ///< unknowns, causes and residual, side by side
  Index m_takenRows = 0;               ///< the rows of `m_taken` that are filled
  std::vector<std::size_t> m_newZero;  ///< readings of the zero that a turn of the axis requires
  std::map<std::pair<std::size_t, std::size_t>, MatrixXd> m_possible;  ///< rows by arc and sighting

  VectorXd overReadings(const auto& valueOf) const {
    return VectorXd::NullaryExpr(std::ssize(m_all.readings),
                                 [&](Index i) { return valueOf(static_cast<std::size_t>(i)); });
  }

  bool isTaken(const LinearReading& reading) const {
    if (reading.isZero) return reading.arc != m_session.newArc;
    return reading.sighting < m_session.taken[reading.arc];
  }

  void addUnknown(std::size_t u) {
    const Unknown& unknown = m_all.unknowns[u];
    const Prior& prior = m_all.priors[u];
    const double sigma = prior.isInformative() ? prior.sigma : widePrior(unknown);
    const Index index = m_result.priorWeights.size();
    m_columns.emplace_back(overReadings([&](std::size_t i) { return m_all.ofUnknown(i, u); }));
    m_result.appendPriors(VectorXd::Constant(1, 1 / sigma));
    if (prior.isInformative()) m_result.priorResiduals[index] = prior.value / sigma;
    if (unknown.kind == Unknown::Kind::CentreY)
      m_result.intersection[index] = intersectionPerHeight(m_session.measurement.arcs[unknown.arc].axisDeg);
  }

  void addUnknown(const EffectParameter& parameter) {
    constexpr double wideSize = 10;  // plausible sizes
    m_columns.emplace_back(columnOf(m_all, parameter.term, plausibleSize(parameter)));
    m_result.appendPriors(VectorXd::Constant(1, 1 / wideSize));
  }

  void add(std::string_view cause, MatrixXd columns, const std::vector<Width>* widths, double odds) {
    m_result.hypotheses.push_back({cause, m_causeColumns, columns.cols(), widths, odds});
    m_causeColumns += columns.cols();
    m_columns.push_back(std::move(columns));
  }

  void addEffect(const Effect& effect) {
    const Index count = std::ssize(effect.parameters);
    MatrixXd columns(m_residual.size(), count + (isBent(effect) ? 3 : 0));
    for (Index c = 0; const EffectParameter& parameter : effect.parameters)
      columns.col(c++) = columnOf(m_all, parameter.term, sizeOf(parameter));
    if (isBent(effect)) columns.rightCols(3) = secondDerivatives(m_session, m_circles, m_all, effect);
    add(effect.id, std::move(columns), effect.response == Response::AllOrNothing ? nullptr : &effectWidths(),
        effect.isSought ? m_odds.effect : 0);
    m_result.hypotheses.back().isBent = isBent(effect);
    m_result.priorOdds += m_result.hypotheses.back().priorOdds;
  }

  /// Returns the plausible size, or the σ of the known size if smaller; subtracts the known value from the
  /// residuals.
  double sizeOf(const EffectParameter& parameter) {
    const auto known = knownOf(m_session.measurement, parameter);
    if (!known) return plausibleSize(parameter);
    m_residual -= columnOf(m_all, parameter.term, known->value);
    return std::min(known->sigma, plausibleSize(parameter));
  }

  /// Adds a jump of both circles in the readings that it moves.
  void addJump(double odds, const auto& isMoved) {
    MatrixXd columns(m_residual.size(), 2);
    columns << columnOf(m_all, ErrorTerm::HorizontalJump, plausibleJump),
        columnOf(m_all, ErrorTerm::VerticalJump, plausibleJump);
    for (Index i = 0; i < columns.rows(); ++i)
      if (!isMoved(m_all.readings[static_cast<std::size_t>(i)])) columns.row(i).setZero();
    add(jumpId, std::move(columns), &jumpWidths(), odds);
  }

  void layOut() {
    m_rows.resize(m_residual.size(), m_result.priorWeights.size() + m_causeColumns + 1);
    for (Index first = 0; const MatrixXd& columns : m_columns) {
      m_rows.middleCols(first, columns.cols()) = columns;
      first += columns.cols();
    }
    m_rows.rightCols(1) = m_residual;
    m_taken.resizeLike(m_rows);
  }

  MatrixXd rowsOf(const std::vector<std::size_t>& readings) const {
    MatrixXd rows(std::ssize(readings), m_rows.cols());
    for (Index r = 0; const std::size_t reading : readings)
      rows.row(r++) = m_rows.row(static_cast<Index>(reading));
    return rows;
  }

  VectorXd alongOf(const std::vector<std::size_t>& readings) const {
    return VectorXd::NullaryExpr(std::ssize(readings), [&](Index r) {
      return m_all.readings[readings[static_cast<std::size_t>(r)]].along;
    });
  }

  SightingRows splitUp(const MatrixXd& rows) const {
    const Index unknowns = m_result.priorWeights.size();
    return {rows.leftCols(unknowns), rows.middleCols(unknowns, m_causeColumns)};
  }

  /// Adds the equations of the visit that begins with the reading `first`. Returns the index after its last.
  std::size_t addVisit(std::size_t first) {
    std::vector<std::size_t> own, sliders;
    std::map<std::size_t, std::vector<std::size_t>> further;  // readings by sighting
    const LinearReading& head = m_all.readings[first];
    std::size_t end = first;
    for (; end < m_all.readings.size() && m_all.readings[end].visit == head.visit; ++end) {
      const LinearReading& reading = m_all.readings[end];
      std::vector<std::size_t>& list = isTaken(reading)                      ? own
                                       : reading.isZero                      ? m_newZero
                                       : reading.kind == ReadingKind::Slider ? sliders
                                                                             : further[reading.sighting];
      list.push_back(end);
    }
    const MatrixXd taken = rowsOf(own);
    if (!own.empty()) {
      const MatrixXd left = withoutArcAngle(taken, alongOf(own));
      m_taken.middleRows(m_takenRows, left.rows()) = left;
      m_takenRows += left.rows();
    }
    for (auto& [sighting, readings] : further) {
      if (own.empty()) readings.insert(readings.end(), sliders.begin(), sliders.end());
      const MatrixXd next = rowsOf(readings);
      m_possible[{head.arc, sighting}] = own.empty()
                                             ? withoutArcAngle(next, alongOf(readings))
                                             : givenTheVisit(next, alongOf(readings), taken, alongOf(own));
    }
    return end;
  }
};

/// Moves the circles by the unknowns that fit the sightings taken. Returns the largest change, mm.
double improve(std::vector<Circle>& circles, const Linearised& all, const SightingEquations& equations) {
  const NormalEquations normal = normalEquationsOf(equations);
  const VectorXd step = normal.matrix.ldlt().solve(normal.right);
  double most = 0;
  for (Index i = 0; const std::size_t u : all.uncertainUnknowns()) {
    const Unknown& unknown = all.unknowns[u];
    const double by = step[i++];
    if (!unknown.isOfAxis()) continue;
    most = std::max(most, std::abs(by));
    for (std::size_t arc = 0; arc < circles.size(); ++arc) {
      if (!unknown.concerns(arc, all.firsts)) continue;
      Circle& circle = circles[arc];
      (unknown.kind == Unknown::Kind::CentreX   ? circle.x
       : unknown.kind == Unknown::Kind::CentreY ? circle.y
                                                : circle.radius) += by;
    }
  }
  return most;
}

}  // namespace

void SightingEquations::appendPriors(const VectorXd& priors) {
  const Index count = priorWeights.size() + priors.size();
  priorWeights.conservativeResize(count);
  priorWeights.tail(priors.size()) = priors;
  for (VectorXd* ofUnknowns : {&priorResiduals, &intersection})
    ofUnknowns->conservativeResizeLike(VectorXd::Zero(count));
}

NormalEquations normalEquationsOf(const SightingEquations& equations) {
  const MatrixXd& unknowns = equations.taken.unknowns;
  MatrixXd matrix = unknowns.transpose() * unknowns;
  matrix.diagonal() += equations.priorWeights.cwiseAbs2();
  return {std::move(matrix), unknowns.transpose() * equations.residual +
                                 equations.priorWeights.cwiseProduct(equations.priorResiduals)};
}

MatrixXd withoutArcAngle(const MatrixXd& rows, const VectorXd& along) {
  if (along.squaredNorm() == 0) return rows;
  const Eigen::HouseholderQR<MatrixXd> qr(along);
  const MatrixXd turned = qr.householderQ().transpose() * rows;
  return turned.bottomRows(rows.rows() - 1);
}

MatrixXd givenTheVisit(const MatrixXd& further, const VectorXd& alongFurther, const MatrixXd& taken,
                       const VectorXd& alongTaken) {
  const double square = alongTaken.squaredNorm();
  const MatrixXd left = further - alongFurther * (alongTaken.transpose() * taken) / square;
  MatrixXd covariance = alongFurther * alongFurther.transpose() / square;
  covariance.diagonal().array() += 1;
  return covariance.llt().matrixL().solve(left);
}

SightingEquations sightingEquations(const Measurement& taken, const SightingPlan& plan,
                                    PossibleSightings& session, bool effectsOnly) {
  constexpr int mostRounds = 4;
  constexpr double tolerance = 2e-3;  // mm
  session = possibleSightings(taken, plan);
  std::vector<Circle> circles(session.measurement.arcs.size(), {0, 0, taken.nominalRadius});
  for (int round = 0; round < mostRounds; ++round) {
    sightPossible(session, plan, circles);
    const Linearised all = linearisedAt(session, circles, {});
    if (improve(circles, all, Assembly(session, plan, circles, all).equations()) < tolerance) break;
  }
  sightPossible(session, plan, circles);
  const Linearised all = linearisedAt(session, circles, everyTerm());
  Assembly assembly(session, plan, circles, all);
  assembly.addEffects();
  if (!effectsOnly) assembly.addFurther();
  SightingEquations equations = assembly.equations();
  for (const int axisDeg : {0, 180})
    equations.intersectionAt +=
        intersectionPerHeight(axisDeg) * circles[arcAt(session.measurement, axisDeg).value()].y;
  return equations;
}

}  // namespace alidade
