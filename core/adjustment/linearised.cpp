#include "core/adjustment/linearised.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/adjustment/joint_problem.h"

namespace alidade {

namespace {

using Eigen::Index;

/// In any unit: what is known as well as that is exact, and its weight, squared, would be no number.
constexpr double asGoodAsZero = 1e-100;

/// The terms of the fit as it found them, the others at zero.
JointFitOptions withTerms(JointFitOptions options, const std::vector<ErrorTerm>& terms) {
  for (const ErrorTerm term : terms)
    if (std::ranges::find(options.terms, term, &EstimatedTerm::term) == options.terms.end())
      options.terms.push_back({term, std::numeric_limits<double>::infinity()});
  if (!options.jumpBefore) options.jumpBefore = 0;
  return options;
}

/// The unknown behind each slot that is no error term, by index into `unknowns`; −1 for none.
std::array<int, firstTermSlot> unknownsOfSlots(const std::vector<Unknown>& unknowns, std::size_t arc) {
  std::array<int, firstTermSlot> slots;
  slots.fill(-1);
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const Unknown& unknown = unknowns[i];
    if (unknown.kind == Unknown::Kind::Distance)
      slots[distanceSlot] = static_cast<int>(i);
    else if (unknown.concerns(arc))
      slots[static_cast<std::size_t>(unknown.kind)] = static_cast<int>(i);
  }
  return slots;
}

Linearised linearisedAt(const Measurement& measurement, const JointProblem& problem, const JointState& state,
                        const std::vector<EstimatedTerm>& terms) {
  Linearised result;
  result.visits = problem.visits().size();
  for (std::size_t i = 0; i < problem.estimated().size(); ++i) {
    const Unknown& unknown = problem.estimated()[i];
    const double beyondPrior = state.unknowns[static_cast<Index>(i)], sigma = problem.priorSigma(i);
    if (unknown.kind == Unknown::Kind::Error) {
      result.termValues[static_cast<std::size_t>(unknown.term)] = beyondPrior + problem.priorValue(i);
      continue;
    }
    result.unknowns.push_back(unknown);
    result.priorSigmas.push_back(sigma);
    result.priorResiduals.push_back(std::isinf(sigma) || sigma == 0 ? 0 : -beyondPrior / sigma);
  }
  for (std::size_t i = 0; i < problem.considered().size(); ++i) {
    result.unknowns.push_back(problem.considered()[i]);
    const double sigma = problem.consideredSigma(i);
    result.priorSigmas.push_back(sigma < asGoodAsZero ? 0 : sigma);
    result.priorResiduals.push_back(0);
  }
  std::vector<std::array<int, firstTermSlot>> slots;
  for (std::size_t arc = 0; arc < measurement.arcs.size(); ++arc)
    slots.push_back(unknownsOfSlots(result.unknowns, arc));
  const std::vector<VisitEquations> all = problem.equationsOf(state);
  std::size_t readings = 0;
  for (const VisitEquations& equations : all) readings += static_cast<std::size_t>(equations.residual.size());
  result.readings.reserve(readings);
  result.perUnknown.assign(readings * result.unknowns.size(), 0);
  result.terms = terms.size();
  for (std::size_t t = 0; t < terms.size(); ++t)
    result.slots[static_cast<std::size_t>(terms[t].term)] = t + 1;
  result.perTerm.reserve(readings * terms.size());
  for (std::size_t v = 0; v < result.visits; ++v) {
    const VisitEquations& equations = all[v];
    const std::size_t arc = problem.visits()[v].arc;
    for (Index row = 0; row < equations.residual.size(); ++row) {
      const std::size_t i = result.readings.size();
      const ReadingRef cell = problem.cellOf(v, row);
      result.readings.push_back({arc, cell.sighting, v,
                                 measurement.arcs[arc].sightings[cell.sighting].sequence, cell.kind,
                                 statedSigma(measurement, cell.kind).radians(), equations.residual[row],
                                 !equations.jacobian.row(row).isZero(0), equations.along[row]});
      for (std::size_t slot = 0; slot < firstTermSlot; ++slot)
        if (slots[arc][slot] >= 0)
          result.perUnknown[i * result.unknowns.size() + static_cast<std::size_t>(slots[arc][slot])] =
              equations.jacobian(row, static_cast<Index>(slot));
      for (std::size_t t = 0; t < terms.size(); ++t)
        result.perTerm.push_back(equations.jacobian(row, static_cast<Index>(firstTermSlot + t)));
    }
  }
  return result;
}

}  // namespace

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
  const JointFitOptions extended = withTerms(options, terms);
  const JointProblem problem(measurement, extended);
  return linearisedAt(measurement, problem, problem.stateOf(fit), extended.terms);
}

Linearised linearise(const Measurement& measurement, const std::vector<Circle>& circles,
                     const JointFitOptions& options, const std::vector<ErrorTerm>& terms) {
  const JointFitOptions extended = withTerms(options, terms);
  const JointProblem problem(measurement, extended);
  return linearisedAt(measurement, problem, problem.start(circles), extended.terms);
}

}  // namespace alidade
