#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"
#include "core/adjustment/joint/reading_columns.h"
#include "core/session/measurement.h"

namespace alidade {

// The equations of a finished adjustment at its solution. Without a new fit, they predict how the readings
// change with small changes of the unknowns, of the pointing zeros, and of every error term of the forward
// model, whether or not the fit estimated it.

/// One circle or slider reading, as in `JointFit::readings`. Millions are stored: `limits::mostRows` rows fit
/// in these types.
struct LinearReading {
  std::uint32_t sighting = 0;  ///< index into the arc's sightings
  std::uint32_t visit = 0;     ///< readings of one visit share their arc angle
  std::uint32_t sequence = 0;  ///< `Sighting::order` of its row
  std::uint32_t number = 0;    ///< among the readings of its kind
  std::uint16_t arc = 0;       ///< index into the measurement's arcs
  ReadingKind kind = ReadingKind::Horizontal;
  bool takesPart = true;
  bool isZero = false;  ///< of a pointing zero
  double sigma = 0;     ///< stated, rad
  double residual = 0;  ///< (observed − adjusted)/σ
  double along = 0;     ///< (∂reading/∂φ)/σ, scaled to unit length over the visit
};

/// An observation of prior knowledge: a whitened equation in one column.
struct PriorRow {
  std::size_t column = 0;
  double derivative = 0, residual = 0;
};

/// An observation of several unknowns at once: a whitened equation over all of them.
struct Condition {
  std::vector<double> derivatives;  ///< in the order of `Linearised::unknowns`
  double residual = 0;
};

/// Whitened: all values are in units of the stated σ of the reading.
struct Linearised {
  std::vector<LinearReading> readings;  ///< visit after visit
  std::size_t visits = 0;
  std::vector<Unknown> unknowns;    ///< circles, slider zeros, pointing zeros and distance; no error terms
  std::vector<std::size_t> firsts;  ///< for each arc, the arc whose centre and radius it shares
  /// Prior of each unknown, relative to its value in the fit, mm or rad. A known radius and the considered
  /// unknowns have their stated σ, 0 if exact.
  std::vector<Prior> priors;
  std::vector<Condition> conditions;  ///< empty after `linearise`; callers with further knowledge add them
  /// Values of the terms in the fit.
  std::array<double, errorTermCount> termValues{};
  /// (∂reading/∂unknown)/σ, a column for each kind of unknown of the reading's own arc.
  ReadingColumns perUnknown;
  /// (∂reading/∂term)/σ per unit of the term (rad, mm or 1), a column for each `ErrorTerm`. If the fit has no
  /// jump, the terms of a jump refer to a jump before every reading.
  ReadingColumns perTerm;

  /// Factor on the stated weight of zero readings.
  double zeroWeight = 1;
  void weighZeros(double weight);

  /// Is the model closed, so that conditions connect the positions?
  bool isClosed() const;
  double ofUnknown(std::size_t reading, std::size_t unknown) const {
    const LinearReading& own = readings[reading];
    const Unknown& by = unknowns[unknown];
    return by.concerns(own.arc, firsts)
               ? perUnknown.at(own.kind, own.number, static_cast<std::size_t>(by.kind))
               : 0;
  }
  double ofTerm(std::size_t reading, ErrorTerm term) const {
    const LinearReading& own = readings[reading];
    return perTerm.at(own.kind, own.number, static_cast<std::size_t>(term));
  }
  /// Indices of the unknowns that are not known exactly.
  std::vector<std::size_t> uncertainUnknowns() const;
  /// Prior knowledge of some unknowns (by index) and terms, whose columns are in this order.
  std::vector<PriorRow> priorRows(const std::vector<std::size_t>& ofUnknowns,
                                  const std::vector<EstimatedTerm>& terms) const;
};

/// All terms, in their order.
const std::vector<ErrorTerm>& everyTerm();

/// `fit` is that of `measurement` with `options`. Derivatives with respect to terms neither in the fit nor
/// among `terms` are zero.
Linearised linearise(const Measurement& measurement, const JointFit& fit, const JointFitOptions& options = {},
                     const std::vector<ErrorTerm>& terms = everyTerm());

/// Linearises readings, such as planned ones, on these circles, one for each arc, without a fit. Delivers
/// pieces of whole visits, since all equations of a large plan would fill the memory. Each piece treats all
/// other readings as excluded.
void linearise(const Measurement& measurement, const std::vector<Circle>& circles,
               const JointFitOptions& options, const std::vector<ErrorTerm>& terms,
               const std::function<void(const Linearised& piece)>& take);

}  // namespace alidade
