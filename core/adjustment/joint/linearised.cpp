#include "core/adjustment/joint/linearised.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/adjustment/joint/joint_problem.h"
#include "core/adjustment/joint/sighted_zeros.h"

namespace alidade {

namespace {

using Eigen::Index;

/// A σ below this counts as exact in any unit, because its squared weight is not finite.
constexpr double asGoodAsZero = 1e-100;

/// The options of the fit with missing `terms` added at zero; a missing jump is added before every row.
JointFitOptions withTerms(JointFitOptions options, const std::vector<ErrorTerm>& terms,
                          const Measurement& measurement) {
  for (const ErrorTerm term : terms)
    if ((!isOwn(term) || (measurement.own && measurement.own->has(term))) &&
        std::ranges::find(options.terms, term, &EstimatedTerm::term) == options.terms.end())
      options.terms.push_back({term, std::numeric_limits<double>::infinity()});
  if (!options.jumpBefore) {
    options.jumpBefore = 0;
    options.jumpEnd.reset();
  }
  return options;
}

/// The slots of circles, zeros and distance are in the order of their kinds.
constexpr auto unknownKinds = static_cast<std::size_t>(Unknown::Kind::Error);
static_assert(distanceSlot == static_cast<int>(Unknown::Kind::Distance));

/// Reserves memory for the readings of visits, from `first` to before `end`.
void reserve(Linearised& result, const std::vector<VisitOfArc>& visits, std::size_t first, std::size_t end) {
  std::size_t rows = 0, sliders = 0;
  for (std::size_t v = first; v < end; ++v) {
    rows += visits[v].visit.sightings.size();
    sliders += visits[v].slider ? 1 : 0;
  }
  result.readings.reserve(2 * rows + sliders);
  result.perUnknown = ReadingColumns(unknownKinds);
  result.perTerm = ReadingColumns(errorTermCount);
  for (ReadingColumns* columns : {&result.perUnknown, &result.perTerm}) {
    columns->reserve(ReadingKind::Horizontal, rows);
    columns->reserve(ReadingKind::Vertical, rows);
    columns->reserve(ReadingKind::Slider, sliders);
  }
}

/// The prior knowledge of unknowns and terms, without a reading.
Linearised withoutReadings(const JointProblem& problem, const JointState& state) {
  Linearised result;
  result.visits = problem.visits().size();
  result.firsts = problem.firsts();
  for (std::size_t i = 0; i < problem.estimated().size(); ++i) {
    const Unknown& unknown = problem.estimated()[i];
    const double beyondPrior = state.unknowns[static_cast<Index>(i)];
    const Prior& prior = problem.prior(i);
    if (unknown.kind == Unknown::Kind::Error) {
      result.termValues[static_cast<std::size_t>(unknown.term)] = beyondPrior + prior.value;
      continue;
    }
    result.unknowns.push_back(unknown);
    result.priors.push_back({-beyondPrior, prior.sigma});
  }
  for (std::size_t i = 0; i < problem.considered().size(); ++i) {
    result.unknowns.push_back(problem.considered()[i]);
    const double sigma = problem.consideredSigma(i);
    result.priors.push_back({0, sigma < asGoodAsZero ? 0 : sigma});
  }
  return result;
}

/// Delivers the equations in pieces of `pieceLength` visits.
void linearise(const Measurement& measurement, const JointProblem& problem, const JointState& state,
               const std::vector<EstimatedTerm>& terms, std::size_t pieceLength,
               const std::function<void(Linearised)>& take) {
  const std::vector<VisitOfArc>& visits = problem.visits();
  Linearised piece;
  std::array<std::uint32_t, readingKinds> counts{};
  problem.eachVisit(state, [&](std::size_t v, const VisitEquations& equations) {
    if (v % pieceLength == 0) {
      piece = withoutReadings(problem, state);
      reserve(piece, visits, v, std::min(v + pieceLength, visits.size()));
      counts = {};
    }
    const std::size_t arc = visits[v].arc;
    for (Index row = 0; row < equations.residual.size(); ++row) {
      const ReadingRef cell = problem.cellOf(v, row);
      const std::uint32_t number = counts[static_cast<std::size_t>(cell.kind)]++;
      const Sighting& sighting = measurement.arcs[arc].sightings[cell.sighting];
      piece.readings.push_back({.sighting = static_cast<std::uint32_t>(cell.sighting),
                                .visit = static_cast<std::uint32_t>(v),
                                .sequence = static_cast<std::uint32_t>(sighting.order),
                                .number = number,
                                .arc = static_cast<std::uint16_t>(arc),
                                .kind = cell.kind,
                                .takesPart = !equations.jacobian.row(row).isZero(0),
                                .isZero = sighting.isZero,
                                .sigma = sigmaOf(measurement, cell).radians(),
                                .residual = equations.residual[row],
                                .along = equations.along[row]});
      for (std::size_t slot = 0; slot < unknownKinds; ++slot)
        piece.perUnknown.append(cell.kind, number, slot, equations.jacobian(row, static_cast<Index>(slot)));
      for (std::size_t t = 0; t < terms.size(); ++t)
        piece.perTerm.append(cell.kind, number, static_cast<std::size_t>(terms[t].term),
                             equations.jacobian(row, static_cast<Index>(firstTermSlot + t)));
    }
    if ((v + 1) % pieceLength == 0 || v + 1 == visits.size()) take(std::move(piece));
  });
}

}  // namespace

void Linearised::weighZeros(double weight) {
  const double factor = weight / zeroWeight;
  zeroWeight = weight;
  if (factor == 1) return;
  for (LinearReading& reading : readings) {
    if (!reading.isZero) continue;
    reading.residual *= factor;
    reading.sigma /= factor;
    perUnknown.scale(reading.kind, reading.number, factor);
    perTerm.scale(reading.kind, reading.number, factor);
  }
}

bool Linearised::isClosed() const {
  const Unknown shared{.kind = Unknown::Kind::CentreX, .arc = Unknown::everyArc};
  return std::ranges::find(unknowns, shared) != unknowns.end();
}

std::vector<std::size_t> Linearised::uncertainUnknowns() const {
  std::vector<std::size_t> indices;
  for (std::size_t u = 0; u < unknowns.size(); ++u)
    if (priors[u].sigma > 0) indices.push_back(u);
  return indices;
}

std::vector<PriorRow> Linearised::priorRows(const std::vector<std::size_t>& ofUnknowns,
                                            const std::vector<EstimatedTerm>& terms) const {
  std::vector<PriorRow> rows;
  std::size_t column = 0;
  const auto add = [&](const Prior& prior, double at) {
    if (prior.isInformative()) rows.push_back({column, prior.derivative(), prior.residual(at)});
    ++column;
  };
  for (const std::size_t u : ofUnknowns) add(priors[u], 0);
  for (const EstimatedTerm& term : terms) add(term.prior(), termValues[static_cast<std::size_t>(term.term)]);
  return rows;
}

const std::vector<ErrorTerm>& everyTerm() {
  static const std::vector<ErrorTerm> all = [] {
    std::vector<ErrorTerm> terms;
    for (std::size_t t = 0; t < errorTermCount; ++t) terms.push_back(static_cast<ErrorTerm>(t));
    return terms;
  }();
  return all;
}

Linearised linearise(const Measurement& measurement, const JointFit& fit, const JointFitOptions& options,
                     const std::vector<ErrorTerm>& terms) {
  const JointFitOptions extended = withTerms(options, terms, measurement);
  const JointProblem problem(measurement, extended);
  const JointState state = problem.stateOf(fit);
  if (problem.visits().empty()) return withoutReadings(problem, state);
  Linearised whole;
  linearise(measurement, problem, state, extended.terms, problem.visits().size(),
            [&](Linearised all) { whole = std::move(all); });
  return whole;
}

void linearise(const Measurement& measurement, const std::vector<Circle>& circles,
               const JointFitOptions& options, const std::vector<ErrorTerm>& terms,
               const std::function<void(const Linearised& piece)>& take) {
  constexpr std::size_t pieceLength = 50'000;  // visits: some ten megabytes
  const JointFitOptions extended = withTerms(options, terms, measurement);
  const JointProblem problem(measurement, extended);
  linearise(measurement, problem, problem.start(circles), extended.terms, pieceLength, take);
}

}  // namespace alidade
