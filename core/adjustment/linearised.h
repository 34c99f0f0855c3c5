#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/adjustment/joint_fit.h"
#include "core/session/measurement.h"

namespace alidade {

// The equations of a finished adjustment at its solution, for everything that asks "what would the readings
// look like if …" without fitting anew: small changes of the unknowns, of the pointing zeros, and of every
// error term of the forward model, whether or not the fit estimated it.

/// One circle or slider reading, as in `JointFit::readings`.
struct LinearReading {
  std::size_t arc = 0;       ///< index into the measurement's arcs
  std::size_t sighting = 0;  ///< index into the arc's sightings
  std::size_t visit = 0;     ///< readings of one visit share their arc angle
  std::size_t sequence = 0;  ///< of its row in the session, in the order taken
  ReadingKind kind = ReadingKind::Horizontal;
  double sigma = 0;     ///< stated, rad
  double residual = 0;  ///< (observed − adjusted)/σ
  bool takesPart = true;
  double along = 0;  ///< (∂reading/∂φ)/σ, scaled to unit length over the visit
};

/// Whitened: everything is in units of the stated σ of the reading.
struct Linearised {
  std::vector<LinearReading> readings;  ///< visit after visit
  std::size_t visits = 0;
  std::vector<Unknown> unknowns;  ///< circles, slider zeros, pointing zeros and distance; no error terms
  /// Of each unknown before the readings: infinite for those the fit estimates freely, the stated σ of a
  /// known radius and of the considered ones. mm or rad.
  std::vector<double> priorSigmas;
  /// (what is known beforehand − value)/σ of each unknown, 0 where nothing is; and the values of the terms.
  std::vector<double> priorResiduals;
  std::array<double, errorTermCount> termValues{};
  /// (∂reading/∂unknown)/σ, readings × unknowns, row by row.
  std::vector<double> perUnknown;
  /// (∂reading/∂term)/σ, readings × terms, row by row: rad, mm or 1 per unit of the term. The terms of a jump
  /// as if it had come before every reading.
  std::vector<double> perTerm;
  std::size_t terms = 0;                            ///< that the readings were differentiated by
  std::array<std::size_t, errorTermCount> slots{};  ///< of each term in a row of `perTerm`, from 1; 0: none

  double ofUnknown(std::size_t reading, std::size_t unknown) const {
    return perUnknown[reading * unknowns.size() + unknown];
  }
  double ofTerm(std::size_t reading, ErrorTerm term) const {
    const std::size_t slot = slots[static_cast<std::size_t>(term)];
    return slot == 0 ? 0 : perTerm[reading * terms + slot - 1];
  }
};

/// The terms there are, in their order.
const std::vector<ErrorTerm>& everyTerm();

/// `fit` is what `fitJointly` made of `measurement` with `options`. Derivatives by terms that are neither in
/// the fit nor among `terms` are left zero.
Linearised linearise(const Measurement& measurement, const JointFit& fit, const JointFitOptions& options = {},
                     const std::vector<ErrorTerm>& terms = everyTerm());

/// Where no fit is needed, since the readings lie on these circles, one for each arc: planned ones, say.
Linearised linearise(const Measurement& measurement, const std::vector<Circle>& circles,
                     const JointFitOptions& options = {}, const std::vector<ErrorTerm>& terms = everyTerm());

}  // namespace alidade
