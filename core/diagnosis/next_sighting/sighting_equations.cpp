#include "core/diagnosis/next_sighting/sighting_equations.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/adjustment/joint/linearised.h"
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
double widePrior(Unknown::Kind kind) {
  constexpr double length = 10, direction = 0.01, slider = 0.1;  // mm, rad, rad
  switch (kind) {
    case Unknown::Kind::HorizontalZero:
    case Unknown::Kind::VerticalZero:
      return direction;
    case Unknown::Kind::SliderZero:
      return slider;
    default:
      return length;
  }
}

bool isBent(const Effect& effect) {
  return effect.response == Response::Bent && effect.parameters.size() == 2;
}

bool isOfModel(const Measurement& measurement, const Effect& effect) {
  return std::ranges::find(measurement.effects, effect.id) != measurement.effects.end();
}

std::vector<const Effect*> effectsFor(const Measurement& measurement, const SightingPlan& plan) {
  std::vector<const Effect*> effects = effectsOf(measurement);
  std::erase_if(effects, [&](const Effect* effect) {
    return (needsSlider(*effect) && !plan.readsSlider) || isOfModel(measurement, *effect);
  });
  return effects;
}

/// The parameters of the effects that the session's own model contains.
std::vector<const EffectParameter*> parametersOfModel(const Measurement& measurement) {
  std::vector<const EffectParameter*> parameters;
  for (const Effect* effect : effectsOf(measurement))
    if (isOfModel(measurement, *effect) && hasSizes(*effect))
      for (const EffectParameter& parameter : effect->parameters) parameters.push_back(&parameter);
  return parameters;
}

/// The readings of a linearised session by visit, with columns for every hypothesis.
class Assembly {
 public:
  /// `bent` are the second derivatives of every reading by the bent effect, `forms` the columns of the
  /// possible forms. If `forms` is null, the effects are the only hypotheses.
  Assembly(const PossibleSightings& session, const SightingPlan& plan, const Linearised& all,
           const std::vector<const Effect*>& effects = {}, const Eigen::MatrixX3d& bent = {},
           const FormColumns* forms = nullptr)
      : m_session(session),
        m_plan(plan),
        m_all(all),
        m_secondDerivatives(bent),
        m_forms(forms),
        m_unknowns(all.uncertainUnknowns()) {
    if (!effects.empty()) m_ofModel = parametersOfModel(session.measurement);
    addPriors();
    if (!effects.empty()) addCauses(effects);
    eachVisit();
  }

  SightingEquations equations() { return std::move(m_result); }

 private:
  const PossibleSightings& m_session;
  const SightingPlan& m_plan;
  const Linearised& m_all;
  const Eigen::MatrixX3d& m_secondDerivatives;
  const FormColumns* m_forms;
  std::vector<std::size_t> m_unknowns;
  std::vector<const EffectParameter*> m_ofModel;      ///< further unknowns, in plausible sizes
  std::vector<std::pair<ErrorTerm, double>> m_known;  ///< known values, subtracted from the residuals
  SightingEquations m_result;
  Index m_columns = 0;
  /// The column of a term. `m_jumps` has columns of jumps by first row, `m_wrongZeros` those of wrong zeros
  /// by arc.
  struct TermColumn {
    ErrorTerm term;
    double size;
    Index column;
  };
  std::vector<TermColumn> m_terms;
  Index m_bent = 0;       ///< first column of the second derivatives
  Index m_firstForm = 0;  ///< first column of the forms
  std::vector<std::pair<std::size_t, Index>> m_jumps, m_wrongZeros;
  std::map<std::size_t, Index> m_grossErrors;  ///< column of the gross error of a reading

  bool isTaken(const LinearReading& reading) const {
    if (reading.isZero) return reading.arc != m_session.newArc;
    return reading.sighting < m_session.taken[reading.arc];
  }

  Index unknownColumns() const { return std::ssize(m_unknowns) + std::ssize(m_ofModel); }

  void addPriors() {
    constexpr double wideSize = 10;  // plausible sizes
    const auto count = static_cast<Index>(m_unknowns.size());
    m_result.priorWeights.setConstant(unknownColumns(), 1 / wideSize);
    m_result.priorResiduals.setZero(unknownColumns());
    m_result.intersection.setZero(unknownColumns());
    for (Index i = 0; i < count; ++i) {
      const std::size_t u = m_unknowns[static_cast<std::size_t>(i)];
      const Unknown& unknown = m_all.unknowns[u];
      const Prior& prior = m_all.priors[u];
      const double sigma = prior.isInformative() ? prior.sigma : widePrior(unknown.kind);
      m_result.priorWeights[i] = 1 / sigma;
      if (prior.isInformative()) m_result.priorResiduals[i] = prior.value / sigma;
      if (unknown.kind == Unknown::Kind::CentreY)
        m_result.intersection[i] = intersectionPerHeight(m_session.measurement.arcs[unknown.arc].axisDeg);
    }
  }

  Index add(std::string_view cause, Index count, const std::vector<Width>* widths, double odds) {
    m_result.hypotheses.push_back({cause, m_columns, count, widths, odds});
    m_columns += count;
    return m_columns - count;
  }

  /// Rows still to be read keep their share of the prior odds of jumps and gross errors. The evidence of the
  /// mixture thus stays a martingale.
  void addCauses(const std::vector<const Effect*>& effects) {
    const PriorOdds odds;
    for (const Effect* effect : effects) {
      const bool isWhole = effect->response == Response::AllOrNothing;
      Index column = add(effect->id, std::ssize(effect->parameters) + (isBent(*effect) ? 3 : 0),
                         isWhole ? nullptr : &effectWidths(), effect->isSought ? odds.effect : 0);
      m_result.priorOdds += m_result.hypotheses.back().priorOdds;
      for (const EffectParameter& parameter : effect->parameters)
        m_terms.push_back({parameter.term, sizeOf(parameter), column++});
      m_result.hypotheses.back().isBent = isBent(*effect);
      if (isBent(*effect)) m_bent = column;
    }
    m_result.effectColumns = m_columns;
    m_result.priorOdds += odds.jump + odds.wrongZero + odds.grossError + odds.noise + odds.shape;
    if (!m_forms) return;
    m_firstForm = m_columns;
    for (std::size_t i = 0; const Index count : m_forms->counts)
      if (const double share = possibleForms()[i++].share; count > 0)
        add(formId, count, &formWidths(), odds.shape * share);
    std::set<std::size_t> orders;
    for (const LinearReading& reading : m_all.readings)
      if (isTaken(reading) && !reading.isZero) orders.insert(reading.sequence);
    const double rows =
        std::max<double>(static_cast<double>(m_plan.rows), static_cast<double>(orders.size()));
    for (const std::size_t order : orders)
      if (order != *orders.begin())
        m_jumps.emplace_back(order, add(jumpId, 2, &jumpWidths(), odds.jump / rows));
    for (std::size_t arc = 0; arc < m_session.newArc; ++arc)
      m_wrongZeros.emplace_back(
          arc, add(jumpId, 2, &jumpWidths(), std::ldexp(odds.wrongZero, -1 - static_cast<int>(arc))));
    for (std::size_t i = 0; i < m_all.readings.size(); ++i)
      if (const LinearReading& reading = m_all.readings[i];
          isTaken(reading) && !reading.isZero && reading.kind != ReadingKind::Slider)
        m_grossErrors[i] = add(grossErrorId, 1, &grossErrorWidths(), odds.grossError / (2 * rows));
  }

  /// Returns the plausible size, or the σ of the known size if smaller; stores the known value for `rowsOf`.
  double sizeOf(const EffectParameter& parameter) {
    const auto known = knownOf(m_session.measurement, parameter);
    if (!known) return plausibleSize(parameter);
    m_known.emplace_back(parameter.term, known->value);
    return std::min(known->sigma, plausibleSize(parameter));
  }

  VectorXd columnsOf(std::size_t i) const {
    const LinearReading& reading = m_all.readings[i];
    VectorXd row = VectorXd::Zero(m_columns);
    for (const auto& [term, size, column] : m_terms) row[column] = m_all.ofTerm(i, term) * size;
    if (m_bent > 0) row.segment<3>(m_bent) = m_secondDerivatives.row(static_cast<Index>(i)).transpose();
    if (m_forms) {
      const MatrixXd& forms = m_forms->columns;
      row.segment(m_firstForm, forms.cols()) = forms.row(static_cast<Index>(i)).transpose();
    }
    const double horizontal = m_all.ofTerm(i, ErrorTerm::HorizontalJump) * plausibleJump,
                 vertical = m_all.ofTerm(i, ErrorTerm::VerticalJump) * plausibleJump;
    const auto step = [&](Index at) {
      row[at] = horizontal;
      row[at + 1] = vertical;
    };
    for (const auto& [order, at] : m_jumps)
      if (reading.sequence >= order) step(at);
    for (const auto& [arc, at] : m_wrongZeros)
      if (reading.arc == arc && !reading.isZero) step(at);
    if (const auto gross = m_grossErrors.find(i); gross != m_grossErrors.end()) row[gross->second] = 1;
    return row;
  }

  /// Unknowns, causes and residual of some readings, side by side.
  MatrixXd rowsOf(const std::vector<std::size_t>& readings) const {
    const Index unknowns = unknownColumns(), ofFit = std::ssize(m_unknowns);
    MatrixXd rows(static_cast<Index>(readings.size()), unknowns + m_columns + 1);
    for (Index r = 0; r < rows.rows(); ++r) {
      const std::size_t i = readings[static_cast<std::size_t>(r)];
      for (Index u = 0; u < ofFit; ++u)
        rows(r, u) = m_all.ofUnknown(i, m_unknowns[static_cast<std::size_t>(u)]);
      for (Index u = ofFit; u < unknowns; ++u) {
        const EffectParameter& parameter = *m_ofModel[static_cast<std::size_t>(u - ofFit)];
        rows(r, u) = m_all.ofTerm(i, parameter.term) * plausibleSize(parameter);
      }
      rows.row(r).segment(unknowns, m_columns) = columnsOf(i);
      double residual = m_all.readings[i].residual;
      for (const auto& [term, value] : m_known) residual -= m_all.ofTerm(i, term) * value;
      rows(r, rows.cols() - 1) = residual;
    }
    return rows;
  }

  VectorXd alongOf(const std::vector<std::size_t>& readings) const {
    VectorXd along(static_cast<Index>(readings.size()));
    for (Index r = 0; r < along.size(); ++r)
      along[r] = m_all.readings[readings[static_cast<std::size_t>(r)]].along;
    return along;
  }

  SightingRows splitUp(const MatrixXd& rows) const {
    const Index unknowns = unknownColumns();
    return {rows.leftCols(unknowns), rows.middleCols(unknowns, m_columns)};
  }

  void eachVisit() {
    std::vector<MatrixXd> taken;
    std::vector<std::size_t> newZero;
    std::map<std::pair<std::size_t, std::size_t>, MatrixXd> possible;  ///< rows by arc and sighting
    for (std::size_t first = 0, end = 0; first < m_all.readings.size(); first = end) {
      std::vector<std::size_t> own, sliders;
      std::map<std::size_t, std::vector<std::size_t>> further;
      const LinearReading& head = m_all.readings[first];
      for (; end < m_all.readings.size() && m_all.readings[end].visit == head.visit; ++end) {
        const LinearReading& reading = m_all.readings[end];
        if (isTaken(reading))
          own.push_back(end);
        else if (reading.isZero)
          newZero.push_back(end);
        else if (reading.kind == ReadingKind::Slider)
          sliders.push_back(end);
        else
          further[reading.sighting].push_back(end);
      }
      if (!own.empty()) taken.push_back(withoutArcAngle(rowsOf(own), alongOf(own)));
      for (auto& [sighting, readings] : further) {
        if (own.empty()) readings.insert(readings.end(), sliders.begin(), sliders.end());
        possible[{head.arc, sighting}] =
            own.empty() ? withoutArcAngle(rowsOf(readings), alongOf(readings))
                        : givenTheVisit(rowsOf(readings), alongOf(readings), rowsOf(own), alongOf(own));
      }
    }
    layOut(taken, newZero, possible);
  }

  void layOut(const std::vector<MatrixXd>& taken, const std::vector<std::size_t>& newZero,
              const std::map<std::pair<std::size_t, std::size_t>, MatrixXd>& possible) {
    Index count = 0;
    for (const MatrixXd& rows : taken) count += rows.rows();
    MatrixXd all(count, unknownColumns() + m_columns + 1);
    count = 0;
    for (const MatrixXd& rows : taken) {
      all.middleRows(count, rows.rows()) = rows;
      count += rows.rows();
    }
    m_result.taken = splitUp(all);
    m_result.residual = all.rightCols(1);
    const MatrixXd zero = rowsOf(newZero);
    for (const auto& [place, rows] : possible) {
      if (place.first != m_session.newArc) {
        m_result.possible.push_back(splitUp(rows));
        continue;
      }
      MatrixXd withZero(zero.rows() + rows.rows(), rows.cols());
      withZero << zero, rows;
      m_result.possible.push_back(splitUp(withZero));
    }
  }
};

Linearised linearisedAt(const PossibleSightings& session, const std::vector<Circle>& circles,
                        const std::vector<ErrorTerm>& terms, const std::vector<EstimatedTerm>& at = {}) {
  Linearised all;
  linearise(session.measurement, circles, {.terms = at, .isClosed = true}, terms,
            [&](const Linearised& piece) { all = piece; });
  return all;
}

/// The second derivatives of every reading by the two numbers of the bent effect, in plausible sizes, from
/// the derivatives at a plausible size of either number. Source: forward differences.
Eigen::MatrixX3d secondDerivatives(const PossibleSightings& session, const std::vector<Circle>& circles,
                                   const Linearised& all, const std::vector<const Effect*>& effects) {
  const auto bent = std::ranges::find_if(effects, [](const Effect* effect) { return isBent(*effect); });
  if (bent == effects.end()) return {};
  const std::vector<EffectParameter>& numbers = (*bent)->parameters;
  const std::vector<ErrorTerm> terms{numbers[0].term, numbers[1].term};
  const auto shifted = [&](std::size_t by) {
    constexpr double free = 1e6;  // rad: no prior knowledge
    const EstimatedTerm at{numbers[by].term, free, 0, plausibleSize(numbers[by])};
    return linearisedAt(session, circles, terms, {at});
  };
  const Linearised first = shifted(0), second = shifted(1);
  Eigen::MatrixX3d columns(std::ssize(all.readings), 3);
  for (std::size_t i = 0; i < all.readings.size(); ++i) {
    const auto change = [&](const Linearised& from, std::size_t of) {
      return (from.ofTerm(i, numbers[of].term) - all.ofTerm(i, numbers[of].term)) *
             plausibleSize(numbers[of]);
    };
    columns.row(static_cast<Index>(i)) << change(first, 0), (change(first, 1) + change(second, 0)) / 2,
        change(second, 1);
  }
  return columns;
}

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
      if (unknown.kind == Unknown::Kind::CentreX) circles[arc].x += by;
      if (unknown.kind == Unknown::Kind::CentreY) circles[arc].y += by;
      if (unknown.kind == Unknown::Kind::Radius) circles[arc].radius += by;
    }
  }
  return most;
}

}  // namespace

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
    if (improve(circles, all, Assembly(session, plan, all).equations()) < tolerance) break;
  }
  sightPossible(session, plan, circles);
  const Linearised all = linearisedAt(session, circles, everyTerm());
  const std::vector<const Effect*> effects = effectsFor(taken, plan);
  const Eigen::MatrixX3d bent = secondDerivatives(session, circles, all, effects);
  FormColumns forms;
  if (!effectsOnly) forms = columnsOfForms(session, circles, all);
  SightingEquations equations =
      Assembly(session, plan, all, effects, bent, effectsOnly ? nullptr : &forms).equations();
  const auto& arcs = session.measurement.arcs;
  for (const int axisDeg : {0, 180})
    equations.intersectionAt +=
        intersectionPerHeight(axisDeg) *
        circles[static_cast<std::size_t>(std::ranges::find(arcs, axisDeg, &ArcMeasurement::axisDeg) -
                                         arcs.begin())]
            .y;
  return equations;
}

}  // namespace alidade
