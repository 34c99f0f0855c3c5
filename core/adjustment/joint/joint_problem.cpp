#include "core/adjustment/joint/joint_problem.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "core/adjustment/joint/arc_jets.h"
#include "core/adjustment/joint/sighted_zeros.h"
#include "core/adjustment/numerics/arc_angle_elimination.h"
#include "core/adjustment/numerics/arc_angle_step.h"
#include "core/observation/half_turn.h"
#include "core/observation/slider_turns.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

std::tuple<std::size_t, std::size_t, ReadingKind> placeOf(const ReadingRef& cell) {
  return {cell.arc, cell.sighting, cell.kind};
}

/// Normal equations over the slots of one arc.
struct SlotSystem {
  SlotMatrix matrix;
  Slots rightSide;
};

/// Adds the equations of a visit with the arc angle eliminated, at least to the lower triangle of the matrix.
/// `Columns`: the number of slots if it is known at compile time, so that the compiler can unroll.
template <int Columns>
void addNormalEquations(SlotSystem& sum, const VisitEquations& equations) {
  constexpr int most = VisitEquations::mostRows,
                mostColumns = Columns == Eigen::Dynamic ? mostSlots : Columns;
  using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Columns, Eigen::RowMajor, most, mostColumns>;
  using Square = Eigen::Matrix<double, Columns, Columns, Eigen::ColMajor, mostColumns, mostColumns>;
  using Vector = Eigen::Matrix<double, Columns, 1, Eigen::ColMajor, mostColumns, 1>;
  const Index rows = equations.jacobian.rows(), columns = equations.jacobian.cols();
  Jacobian reduced = Eigen::Map<const Jacobian>(equations.jacobian.data(), rows, columns);
  Vector share;
  eliminateArcAngle(reduced, equations.along, share);
  Eigen::Map<Square> matrix(sum.matrix.data(), columns, columns);
  Eigen::Map<Vector> rightSide(sum.rightSide.data(), columns);
  for (Index i = 0; i < rows; ++i) {  // by rows: inner products this short are slower
    const Vector row = reduced.row(i).transpose();
    if constexpr (Columns == Eigen::Dynamic)  // only half the matrix: with many terms this takes most time
      for (Index j = 0; j < columns; ++j) matrix.col(j).tail(columns - j) += row[j] * row.tail(columns - j);
    else
      matrix += row.lazyProduct(row.transpose());
    rightSide += row * equations.residual[i];
  }
}

}  // namespace

JointProblem::JointProblem(const Measurement& measurement, const JointFitOptions& options)
    : m_measurement(measurement),
      m_terms(options.terms),
      m_jumpBefore(options.jumpBefore),
      m_jumpEnd(options.jumpEnd),
      m_isClosed(options.isClosed),
      m_firsts(firstAtTheirAxes(measurement)),
      m_without(options.without) {
  m_estimatesZeros = m_isClosed || options.estimatesZeros || (hasRepeats(measurement) && !options.isApart);
  if (std::ranges::any_of(m_terms, isOwn, &EstimatedTerm::term))
    m_own = std::make_unique<OwnModel>(measurement.own);
  if (options.isApart) std::iota(m_firsts.begin(), m_firsts.end(), std::size_t{0});
  for (std::size_t arc = 0; arc < measurement.arcs.size(); ++arc) {
    addArc(arc);
    for (Visit& visit : visitsOf(measurement.arcs[arc])) {
      const Sighting* slider = sliderOf(measurement.arcs[arc], visit);
      m_visits.push_back({arc, std::move(visit), slider});
    }
  }
  if (m_isClosed) estimate({.kind = Unknown::Kind::CentreX, .arc = Unknown::everyArc}, {});
  if (sharesRadius()) estimate({.kind = Unknown::Kind::Radius, .arc = Unknown::everyArc}, radiusPrior());
  for (const EstimatedTerm& term : m_terms)
    estimate({.kind = Unknown::Kind::Error, .arc = 0, .term = term.term}, term.prior());
  consider({.kind = Unknown::Kind::Distance}, measurement.sigmaDistance);
  buildSlotMaps();
  std::ranges::sort(m_without, {}, placeOf);
}

void JointProblem::addArc(std::size_t arc) {
  using enum Unknown::Kind;
  std::vector<Unknown::Kind> kinds;
  if (m_firsts[arc] == arc) {
    if (!m_isClosed) kinds.push_back(CentreX);
    kinds.push_back(CentreY);
    if (!sharesRadius()) kinds.push_back(Radius);
  }
  if (hasSliderReadings(m_measurement.arcs[arc])) kinds.push_back(SliderZero);
  for (const auto kind : kinds) estimate({.kind = kind, .arc = arc}, {});
  if (const auto& sighted = m_measurement.sightedZeros) {
    for (const auto& [kind, isCommon] :
         {std::pair(HorizontalZero, sighted->horizontal), std::pair(VerticalZero, sighted->vertical)})
      if (!isCommon || arc == 0) estimate({.kind = kind, .arc = isCommon ? Unknown::everyArc : arc}, {});
    return;
  }
  if (m_measurement.hasOneZero() && arc > 0) return;
  const std::size_t of = m_measurement.hasOneZero() ? Unknown::everyArc : arc;
  const ArcMeasurement& own = m_measurement.arcs[arc];
  addZero({.kind = HorizontalZero, .arc = of}, m_measurement.sigmaOfZeroHorizontal(own).radians());
  addZero({.kind = VerticalZero, .arc = of}, m_measurement.sigmaOfZeroVertical(own).radians());
}

void JointProblem::addZero(const Unknown& zero, double sigma) {
  constexpr double exact = 1e-15;  // rad; a smaller σ counts as exact
  if (m_estimatesZeros && sigma > exact)
    estimate(zero, {0, sigma});
  else
    consider(zero, sigma);
}

bool JointProblem::sharesRadius() const {
  return m_isClosed || m_measurement.radiusModel != RadiusModel::Free;
}

Prior JointProblem::radiusPrior() const {
  // An exact radius gets a σ of a nanometre: far below the resolution of any reading, far above rounding.
  constexpr double exact = 1e-6;
  const double radius = m_measurement.nominalRadius, sigma = m_measurement.sigmaRadius;
  if (m_measurement.radiusModel == RadiusModel::Known) return {radius, std::max(sigma, exact)};
  if (!m_isClosed || !(sigma > 0)) return {};
  // The readings see R/L. An R0 weighed as if L were exact would bend the arcs by the error of L.
  return {radius, std::hypot(sigma, radius * m_measurement.sigmaDistance / m_measurement.distance)};
}

void JointProblem::estimate(const Unknown& unknown, const Prior& prior) {
  m_estimated.push_back(unknown);
  m_priors.push_back(prior);
}

void JointProblem::consider(const Unknown& unknown, double sigma) {
  m_considered.push_back(unknown);
  m_consideredSigmas.push_back(sigma);
}

void JointProblem::buildSlotMaps() {
  m_slotMaps.resize(m_measurement.arcs.size());
  for (std::size_t arc = 0; arc < m_slotMaps.size(); ++arc) {
    m_slotMaps[arc].fill(-1);
    std::size_t term = firstTermSlot;
    Index index = 0;
    for (const auto* unknowns : {&m_estimated, &m_considered})
      for (const Unknown& unknown : *unknowns) {
        if (unknown.kind == Unknown::Kind::Error)
          m_slotMaps[arc][term++] = index;
        else if (unknown.kind == Unknown::Kind::Distance)
          m_slotMaps[arc][distanceSlot] = index;
        else if (unknown.concerns(arc, m_firsts))
          m_slotMaps[arc][static_cast<std::size_t>(unknown.kind)] = index;
        ++index;
      }
  }
}

double JointProblem::meanOf(const Unknown& unknown, const std::vector<Circle>& circles) const {
  double sum = 0;
  int count = 0;
  for (std::size_t arc = 0; arc < circles.size(); ++arc) {
    if (!unknown.concerns(arc, m_firsts)) continue;
    const Circle& circle = circles[arc];
    sum += unknown.kind == Unknown::Kind::CentreX   ? circle.x
           : unknown.kind == Unknown::Kind::CentreY ? circle.y
                                                    : circle.radius;
    ++count;
  }
  return sum / count;
}

JointState JointProblem::start(const std::vector<Circle>& circles) const {
  JointState state{VectorXd::Zero(count()), VectorXd::Zero(static_cast<Index>(m_visits.size()))};
  for (std::size_t i = 0; i < m_estimated.size(); ++i) {
    using enum Unknown::Kind;
    const Unknown& unknown = m_estimated[i];
    double& value = state.unknowns[static_cast<Index>(i)];
    if (unknown.isOfAxis()) value = meanOf(unknown, circles) - m_priors[i].value;
    for (const EstimatedTerm& term : m_terms)
      if (unknown.kind == Error && unknown.term == term.term) value = term.start - term.priorValue;
  }
  for (std::size_t v = 0; v < m_visits.size(); ++v) {
    const ArcMeasurement& arc = m_measurement.arcs[m_visits[v].arc];
    const PlanePoint<double> place =
        ZeroLine(m_measurement, arc).sightedPoint(m_visits[v].visit.mean.direction);
    state.arcAngles[static_cast<Index>(v)] =
        unwrappedArcAngle(nearestArcAngle(circles[m_visits[v].arc], place), arc.axisDeg);
  }
  eachArc(state, [&](std::size_t arc, std::span<double> arcAngles, Sliders sliders) {
    unwrapAlongSlider(arcAngles, sliders, m_measurement.arcs[arc].axisDeg);
    const Index zero = m_slotMaps[arc][static_cast<std::size_t>(Unknown::Kind::SliderZero)];
    if (zero >= 0) state.unknowns[zero] = sliderZero(arcAngles, sliders, m_measurement.arcs[arc].axisDeg);
  });
  return state;
}

JointState JointProblem::stateOf(const JointFit& fit) const {
  JointState state{VectorXd::Zero(count()), VectorXd::Zero(static_cast<Index>(m_visits.size()))};
  for (std::size_t i = 0; i < m_estimated.size(); ++i) {
    const std::size_t found = fit.indexOf(m_estimated[i]);
    if (found < fit.values.size())
      state.unknowns[static_cast<Index>(i)] = fit.values[found] - m_priors[i].value;
  }
  for (std::size_t v = 0; v < m_visits.size(); ++v)
    state.arcAngles[static_cast<Index>(v)] =
        fit.arcAngles[m_visits[v].arc][m_visits[v].visit.sightings.front()];
  eachArc(state, [&](std::size_t arc, std::span<double> arcAngles, Sliders sliders) {
    unwrapAlongSlider(arcAngles, sliders, m_measurement.arcs[arc].axisDeg);
  });
  return state;
}

void JointProblem::eachArc(JointState& state, const TakeArc& take) const {
  std::vector<const Sighting*> sliders;
  for (const VisitOfArc& visit : m_visits) sliders.push_back(visit.slider);
  for (std::size_t first = 0, end = 0; first < m_visits.size(); first = end) {
    while (end < m_visits.size() && m_visits[end].arc == m_visits[first].arc) ++end;
    take(m_visits[first].arc, std::span(state.arcAngles.data() + first, end - first),
         std::span(sliders).subspan(first, end - first));
  }
}

ReadingRef JointProblem::cellOf(std::size_t visitIndex, Index row) const {
  const auto& [arc, visit, slider] = m_visits[visitIndex];
  const auto pair = static_cast<std::size_t>(row) / 2;
  if (pair < visit.sightings.size())
    return {arc, visit.sightings[pair], row % 2 == 0 ? ReadingKind::Horizontal : ReadingKind::Vertical};
  const auto sighting = static_cast<std::size_t>(slider - m_measurement.arcs[arc].sightings.data());
  return {arc, sighting, ReadingKind::Slider};
}

template <typename Jets>
Jets JointProblem::jetsOf(const JointState& state, std::size_t arc) const {
  using GuidewayJet = typename Jets::GuidewayJet;
  const auto value = [&](std::size_t slot, double base) {
    const Index unknown = m_slotMaps[arc][slot];
    return unknown < 0 ? base : base + state.unknowns[unknown];
  };
  const auto guideway = [&](int slot, Unknown::Kind kind, double base) {
    return Jets::template variable<GuidewayJet>(value(static_cast<std::size_t>(kind), base), slot);
  };
  using enum Unknown::Kind;
  Jets jets;
  jets.pose.x = guideway(Jets::xSlot, CentreX, 0);
  jets.pose.y = guideway(Jets::ySlot, CentreY, 0);
  jets.pose.radius = guideway(Jets::radiusSlot, Radius, sharesRadius() ? radiusPrior().value : 0);
  jets.pose.sliderZero = guideway(Jets::sliderSlot, SliderZero, 0);
  jets.distance =
      Jets::template variable<GuidewayJet>(value(distanceSlot, m_measurement.distance), Jets::farSlot);
  jets.horizontalZero = value(static_cast<std::size_t>(HorizontalZero), 0);
  for (std::size_t t = 0; t < m_terms.size(); ++t)
    jets.set(m_terms[t].term, value(firstTermSlot + t, m_terms[t].priorValue));
  const double elevation = m_measurement.arcs[arc].zeroElevation.radians(),
               ofVerticalZero = value(static_cast<std::size_t>(VerticalZero), 0);
  if (m_measurement.sightedZeros) {  // the zeros are separate observations
    jets.zeroElevation = elevation + ofVerticalZero;
    return jets;
  }
  const double distance = jets.distance.value();
  const auto ahead =
      roomFromZeroLine(SpacePoint<double>{0, 0, -distance}, distance, elevation, m_measurement.plane);
  const auto mark = Jets::asTarget(ahead.x, ahead.y, ahead.z);
  Pointing pointing = zeroPointing(m_measurement.arcs[arc]);
  std::optional<OwnPlace> own;
  if (m_own) pointing.own = &own.emplace(m_own->zeroOf(m_measurement, m_measurement.arcs[arc]));
  jets.zero = circleDirection(jets.instrumentErrors, mark, pointing);
  if (m_measurement.arcs[arc].zero.isInBothFaces) {
    pointing.face = 2;
    if (own) own->row.face = -1;
    const auto inTwo = circleDirection(jets.instrumentErrors, mark, pointing);
    jets.zero.a = (jets.zero.a + inTwo.a) / 2.0;
    jets.zero.e = (jets.zero.e + inTwo.e) / 2.0;
  }
  jets.zero.e -= elevation;
  jets.zeroElevation = elevation - jets.zero.e.value() + ofVerticalZero;
  return jets;
}

Pointing JointProblem::zeroPointing(const ArcMeasurement& arc) const {
  Pointing pointing;
  pointing.horizontalZero = arc.zeroHorizontal.radians();
  pointing.circle = m_measurement.verticalCircle;
  pointing.relation = m_measurement.relation;
  pointing.elapsed = arc.zero.elapsed;
  // A jump before everything, which `linearise` requests, counts as a jump just after the zeros.
  if (!arc.zeroSightings.empty() && m_jumpBefore.value_or(0) > 0)
    pointing.jumpShare =
        static_cast<double>(std::ranges::count_if(
            arc.zeroSightings, [&](const SightedZero& zero) { return hasJumped(zero.order); })) /
        static_cast<double>(arc.zeroSightings.size());
  return pointing;
}

Pointing JointProblem::pointingOf(const ArcMeasurement& arc, const Sighting& sighting) const {
  Pointing pointing = zeroPointing(arc);
  pointing.face = sighting.face;
  pointing.elapsed = sighting.elapsed;
  pointing.isSetUpAgain = &arc != m_measurement.arcs.data() && !sighting.isZero;
  pointing.jumpShare = hasJumped(sighting.order) ? 1 : 0;
  return pointing;
}

bool JointProblem::hasJumped(std::size_t order) const {
  return m_jumpBefore && order >= *m_jumpBefore && (!m_jumpEnd || order < *m_jumpEnd);
}

bool JointProblem::takesPart(std::size_t arc, std::size_t sighting, ReadingKind kind) const {
  return !std::ranges::binary_search(m_without, std::tuple(arc, sighting, kind), {}, placeOf);
}

/// Calls `function` with the shortest jets that have the derivatives of all terms.
template <typename Function>
auto JointProblem::withJets(const Function& function) const {
  if (m_terms.empty()) return function(ArcJets<ArcTerms::None>());
  if (m_own) return function(ArcJets<ArcTerms::AlsoOwn>());
  if (std::ranges::all_of(m_terms, isOfGuideway, &EstimatedTerm::term))
    return function(ArcJets<ArcTerms::OfGuideway>());
  return function(ArcJets<ArcTerms::All>());
}

VisitEquations JointProblem::equationsOf(const JointState& state, std::size_t visit) const {
  VisitEquations equations;
  withJets([&](auto jets) {
    fillEquations(jetsOf<decltype(jets)>(state, m_visits[visit].arc), state, visit, equations);
  });
  return equations;
}

std::vector<VisitEquations> JointProblem::equationsOf(const JointState& state) const {
  std::vector<VisitEquations> equations;
  fillEquations(state, equations);
  return equations;
}

template <typename Fill>
void JointProblem::withJetsOfEachVisit(const JointState& state, const Fill& fill) const {
  withJets([&](auto kind) {
    using Jets = decltype(kind);
    std::vector<Jets> jets;
    for (std::size_t arc = 0; arc < m_measurement.arcs.size(); ++arc)
      jets.push_back(jetsOf<Jets>(state, arc));
    for (std::size_t v = 0; v < m_visits.size(); ++v) fill(jets[m_visits[v].arc], v);
  });
}

void JointProblem::fillEquations(const JointState& state, std::vector<VisitEquations>& equations) const {
  equations.resize(m_visits.size());
  withJetsOfEachVisit(state,
                      [&](const auto& jets, std::size_t v) { fillEquations(jets, state, v, equations[v]); });
}

void JointProblem::eachVisit(const JointState& state,
                             const std::function<void(std::size_t, const VisitEquations&)>& take) const {
  VisitEquations one;
  withJetsOfEachVisit(state, [&](const auto& jets, std::size_t v) {
    fillEquations(jets, state, v, one);
    take(v, one);
  });
}

namespace {

/// The displacement of a target in space per change of the zero line's elevation.
struct PerElevation {
  double y = 0, z = 0;  ///< mm per rad

  template <typename Der>
  double of(const Der& byTarget) const {
    return byTarget[1] * y + byTarget[2] * z;
  }
};

/// Returns the `PerElevation` of a target at `y` and `z`, mm.
PerElevation perElevation(double y, double z, double distance, double elevation, ArcPlane plane) {
  if (plane == ArcPlane::Square) return {-z, y};
  const double cosine = std::cos(elevation);
  return {distance / (cosine * cosine), 0};
}

/// The row of a circle reading: derivatives with respect to the target's place and to the instrument's terms,
/// which also rotate the zero line.
template <typename Jets>
void fillRow(VisitEquations::Jacobian::RowXpr row, const typename Jets::InstrumentJet& sighted,
             const typename Jets::InstrumentJet& zeroElevation, const PerElevation& perElevation,
             const SpacePoint<typename Jets::GuidewayJet>& target, const std::vector<EstimatedTerm>& terms) {
  const auto& by = sighted.derivatives();
  const typename Jets::GuidewayJet::DerType place =
      by[0] * target.x.derivatives() + by[1] * target.y.derivatives() + by[2] * target.z.derivatives();
  const double turn = perElevation.of(by);
  row.setZero();
  row[static_cast<int>(Unknown::Kind::CentreX)] = place[Jets::xSlot];
  row[static_cast<int>(Unknown::Kind::CentreY)] = place[Jets::ySlot];
  row[static_cast<int>(Unknown::Kind::Radius)] = place[Jets::radiusSlot];
  row[static_cast<int>(Unknown::Kind::VerticalZero)] = turn;
  row[distanceSlot] = place[Jets::farSlot];
  row[phiSlot] = place[Jets::angleSlot];
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const auto slot = static_cast<Index>(firstTermSlot + t);
    const Index own = Jets::slotOf(terms[t].term);
    if (isOfGuideway(terms[t].term))
      row[slot] = place[own];
    else
      row[slot] = by[own] - turn * zeroElevation.derivatives()[own];
  }
}

/// Subtracts the derivatives of the zero as read, from which directions count.
template <typename Jets>
void takeOffZero(VisitEquations::Jacobian::RowXpr row, const typename Jets::InstrumentJet& zero,
                 const std::vector<EstimatedTerm>& terms) {
  row[static_cast<int>(Unknown::Kind::HorizontalZero)] = -1;
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (!isOfGuideway(terms[t].term))
      row[static_cast<Index>(firstTermSlot + t)] -= zero.derivatives()[Jets::slotOf(terms[t].term)];
}

template <typename Jets>
void fillSliderRow(VisitEquations::Jacobian::RowXpr row, const typename Jets::GuidewayJet& reading,
                   const std::vector<EstimatedTerm>& terms) {
  const auto& by = reading.derivatives();
  row.setZero();
  row[static_cast<int>(Unknown::Kind::SliderZero)] = by[Jets::sliderSlot];
  row[phiSlot] = by[Jets::angleSlot];
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (isOfGuideway(terms[t].term))
      row[static_cast<Index>(firstTermSlot + t)] = by[Jets::slotOf(terms[t].term)];
}

/// The part of ∂(a, e)/∂φ from the user's own effects on the circles, through the slider coordinate s.
struct OwnSlopes {
  double a = 0, e = 0;
};

template <typename Jets>
OwnSlopes ownSlopes(const Jets& jets, const OwnPlace& own,
                    const Direction<typename Jets::InstrumentJet>& sighted) {
  OwnSlopes slopes;
  for (const OwnShare& share : own.model->ofCircles(own, sighted.a.value(), sighted.e.value())) {
    const double slope = jets.instrumentErrors[share.term].value() * share.byArcAngle;
    if (share.carrier != FormCarrier::Vertical) slopes.a += slope;
    if (share.carrier != FormCarrier::Horizontal) slopes.e += slope;
  }
  return slopes;
}

}  // namespace

/// Fills the equations of a sighting of the zero, whose mark is independent of the guideway.
template <typename Jets>
void JointProblem::fillZeroEquations(const Jets& jets, std::size_t visitIndex,
                                     VisitEquations& equations) const {
  const std::size_t arcIndex = m_visits[visitIndex].arc, index = m_visits[visitIndex].visit.sightings.front();
  const ArcMeasurement& arc = m_measurement.arcs[arcIndex];
  const Sighting& sighting = arc.sightings[index];
  const double distance = jets.distance.value();
  const auto mark = roomFromZeroLine(SpacePoint<double>{0, 0, -distance}, distance, jets.zeroElevation,
                                     m_measurement.plane);
  Pointing pointing = pointingOf(arc, sighting);
  std::optional<OwnPlace> own;
  if (m_own) pointing.own = &own.emplace(m_own->placeOf(m_measurement, arc, sighting, 0));
  const auto sighted =
      circleDirection(jets.instrumentErrors, Jets::asTarget(mark.x, mark.y, mark.z), pointing);
  const PerElevation turn = perElevation(mark.y, mark.z, distance, jets.zeroElevation, m_measurement.plane);
  equations.residual.resize(2);
  equations.jacobian.setZero(2, slots());
  const auto fill = [&](Index row, const auto& reading, double difference, ReadingKind kind) {
    equations.jacobian(row, static_cast<int>(Unknown::Kind::VerticalZero)) = turn.of(reading.derivatives());
    for (std::size_t t = 0; t < m_terms.size(); ++t)
      if (!isOfGuideway(m_terms[t].term))
        equations.jacobian(row, static_cast<Index>(firstTermSlot + t)) =
            reading.derivatives()[Jets::slotOf(m_terms[t].term)];
    if (kind == ReadingKind::Horizontal)
      equations.jacobian(row, static_cast<int>(Unknown::Kind::HorizontalZero)) = -1;
    const double sigma = sigmaOf(m_measurement, sighting, kind == ReadingKind::Vertical).radians();
    const double weight = takesPart(arcIndex, index, kind) ? 1 / sigma : 0;
    equations.residual[row] = difference * weight;
    equations.jacobian.row(row) *= weight;
  };
  fill(0, sighted.a, sighting.a.radians() - (sighted.a.value() - jets.horizontalZero),
       ReadingKind::Horizontal);
  fill(1, sighted.e, sighting.e.radians() + arc.zeroElevation.radians() - sighted.e.value(),
       ReadingKind::Vertical);
  equations.along.setZero(2);
}

template <typename Jets>
void JointProblem::fillEquations(const Jets& jets, const JointState& state, std::size_t visitIndex,
                                 VisitEquations& equations) const {
  const auto& [arcIndex, visit, slider] = m_visits[visitIndex];
  const ArcMeasurement& arc = m_measurement.arcs[arcIndex];
  if (arc.sightings[visit.sightings.front()].isZero) {
    fillZeroEquations(jets, visitIndex, equations);
    return;
  }
  using GuidewayJet = typename Jets::GuidewayJet;
  using InstrumentJet = typename Jets::InstrumentJet;
  const GuidewayJet phi =
      Jets::template variable<GuidewayJet>(state.arcAngles[static_cast<Index>(visitIndex)], Jets::angleSlot);
  // Set for each row, since the user's own effects may differ between the rows of a visit. Unset if the model
  // has no own effects.
  std::optional<OwnPlace> own;
  const auto placeAt = [&]() {
    return roomFromZeroLine(
        targetAt(jets.guidewayErrors, jets.pose, jets.distance, phi, arc.axisDeg, own ? &*own : nullptr),
        jets.distance, jets.zeroElevation, m_measurement.plane);
  };
  SpacePoint<GuidewayJet> place = placeAt();
  const auto turned = [&]() {
    return perElevation(place.y.value(), place.z.value(), jets.distance.value(), jets.zeroElevation,
                        m_measurement.plane);
  };
  PerElevation turn = turned();
  SpacePoint<InstrumentJet> target = Jets::asTarget(place.x.value(), place.y.value(), place.z.value());
  // A perfect instrument reads the same in both faces.
  const bool isPerfect = jets.instrumentErrors.isPerfect();
  Direction<InstrumentJet> sighted = jets.zero;
  if (isPerfect) sighted = circleDirection(jets.instrumentErrors, target, zeroPointing(arc));

  assert(visit.sightings.size() <= 2);
  const auto rows = static_cast<Index>(2 * visit.sightings.size() + (slider ? 1 : 0));
  equations.residual.resize(rows);
  equations.jacobian.resize(rows, slots());
  Index row = 0;
  const auto weigh = [&](double difference, double sigma, bool takesPart) {
    const double weight = takesPart ? 1 / sigma : 0;
    equations.residual[row] = difference * weight;
    equations.jacobian.row(row++) *= weight;
  };
  for (const std::size_t i : visit.sightings) {
    const Sighting& sighting = arc.sightings[i];
    if (m_own) {
      own = m_own->placeOf(m_measurement, arc, sighting, phi.value());
      place = placeAt();
      turn = turned();
      target = Jets::asTarget(place.x.value(), place.y.value(), place.z.value());
    }
    Pointing pointing = pointingOf(arc, sighting);
    pointing.own = own ? &*own : nullptr;
    if (!isPerfect || own) sighted = circleDirection(jets.instrumentErrors, target, pointing);
    fillRow<Jets>(equations.jacobian.row(row), sighted.a, jets.zero.e, turn, place, m_terms);
    takeOffZero<Jets>(equations.jacobian.row(row), jets.zero.a, m_terms);
    const OwnSlopes slopes = own ? ownSlopes(jets, *own, sighted) : OwnSlopes();
    equations.jacobian(row, phiSlot) += slopes.a;
    weigh(sighting.a.radians() - (sighted.a.value() - jets.zero.a.value() - jets.horizontalZero),
          m_measurement.sigmaHorizontal.radians(), takesPart(arcIndex, i, ReadingKind::Horizontal));
    fillRow<Jets>(equations.jacobian.row(row), sighted.e, jets.zero.e, turn, place, m_terms);
    equations.jacobian(row, phiSlot) += slopes.e;
    weigh(sighting.e.radians() + arc.zeroElevation.radians() - sighted.e.value(),
          m_measurement.sigmaVertical.radians(), takesPart(arcIndex, i, ReadingKind::Vertical));
  }
  if (slider) {
    if (m_own) own = m_own->placeOf(m_measurement, arc, *slider, phi.value());
    const GuidewayJet s = observeSlider(jets.guidewayErrors, jets.pose, phi, arc.axisDeg,
                                        jets.distance.value(), own ? &*own : nullptr);
    fillSliderRow<Jets>(equations.jacobian.row(row), s, m_terms);
    weigh(wrapped(*slider->slider - Angle::fromRadians(s.value())).radians(),
          m_measurement.sigmaSlider.radians(),
          takesPart(arcIndex, static_cast<std::size_t>(slider - arc.sightings.data()), ReadingKind::Slider));
  }
  equations.along = equations.jacobian.col(phiSlot);
  equations.along.normalize();
}

VisitEquations::Jacobian JointProblem::reduced(const VisitEquations& equations) {
  VisitEquations::Jacobian reduced = equations.jacobian;
  Slots share;
  eliminateArcAngle(reduced, equations.along, share);
  return reduced;
}

Slots JointProblem::reduced(const VisitEquations& equations, Index row) {
  return reduced(equations).row(row).transpose();
}

VectorXd JointProblem::spread(const Slots& values, std::size_t arc) const {
  VectorXd all = VectorXd::Zero(count());
  for (std::size_t slot = 0; slot < static_cast<std::size_t>(slots()); ++slot)
    if (m_slotMaps[arc][slot] >= 0) all[m_slotMaps[arc][slot]] = values[static_cast<Index>(slot)];
  return all;
}

Slots JointProblem::gathered(const VectorXd& values, std::size_t arc) const {
  Slots result = Slots::Zero(slots());
  for (Index slot = 0; slot < slots(); ++slot)
    if (const Index i = m_slotMaps[arc][static_cast<std::size_t>(slot)]; i >= 0 && i < values.size())
      result[slot] = values[i];
  return result;
}

SlotMatrix JointProblem::gathered(const MatrixXd& values, std::size_t arc) const {
  SlotMatrix result(slots(), slots());
  const Slots nothing = Slots::Zero(slots());
  for (Index slot = 0; slot < slots(); ++slot) {
    const Index i = m_slotMaps[arc][static_cast<std::size_t>(slot)];
    result.col(slot) = i >= 0 && i < values.cols() ? gathered(VectorXd(values.col(i)), arc) : nothing;
  }
  return result;
}

JointSystem JointProblem::system(const JointState& state, JointSystem used) const {
  JointSystem system = std::move(used);
  fillEquations(state, system.equations);
  system.matrix.setZero(count(), count());
  system.rightSide.setZero(count());
  system.chiSquare = 0;
  const SlotSystem nothing{SlotMatrix::Zero(slots(), slots()), Slots::Zero(slots())};
  std::vector<SlotSystem> ofArcs(m_measurement.arcs.size(), nothing);
  for (std::size_t v = 0; v < m_visits.size(); ++v) {
    const VisitEquations& equations = system.equations[v];
    system.chiSquare += equations.residual.squaredNorm();
    SlotSystem& ofArc = ofArcs[m_visits[v].arc];
    if (m_terms.empty())
      addNormalEquations<firstTermSlot>(ofArc, equations);
    else
      addNormalEquations<Eigen::Dynamic>(ofArc, equations);
  }
  for (std::size_t arc = 0; arc < ofArcs.size(); ++arc) {
    const auto& map = m_slotMaps[arc];
    for (std::size_t i = 0; i < static_cast<std::size_t>(slots()); ++i) {
      if (map[i] < 0) continue;
      system.rightSide[map[i]] += ofArcs[arc].rightSide[static_cast<Index>(i)];
      for (std::size_t j = 0; j < static_cast<std::size_t>(slots()); ++j)
        if (map[j] >= 0)
          system.matrix(map[i], map[j]) +=
              ofArcs[arc].matrix(static_cast<Index>(std::max(i, j)), static_cast<Index>(std::min(i, j)));
    }
  }
  for (std::size_t i = 0; i < m_estimated.size(); ++i) {
    if (!m_priors[i].isInformative()) continue;
    const double weight = m_priors[i].weight();
    const auto index = static_cast<Index>(i);
    const double away = state.unknowns[index];
    system.matrix(index, index) += weight;
    system.rightSide[index] -= weight * away;
    system.chiSquare += weight * away * away;
  }
  return system;
}

JointState JointProblem::moved(const JointState& state, const std::vector<VisitEquations>& all,
                               const VectorXd& step) const {
  JointState result = state;
  result.unknowns.head(step.size()) += step;
  for (std::size_t v = 0; v < m_visits.size(); ++v) {
    const VisitEquations& equations = all[v];
    auto residual = equations.residual;
    const auto& map = m_slotMaps[m_visits[v].arc];
    for (std::size_t slot = 0; slot < static_cast<std::size_t>(slots()); ++slot)
      if (map[slot] >= 0 && map[slot] < step.size())
        residual -= equations.jacobian.col(static_cast<Index>(slot)) * step[map[slot]];
    const double length = equations.jacobian.col(phiSlot).norm();
    if (length == 0) continue;  // the whole visit is excluded
    const double turn = equations.along.dot(residual) / length;
    result.arcAngles[static_cast<Index>(v)] += boundedArcAngleStep(turn);
  }
  return result;
}

}  // namespace alidade
