#pragma once

#include <vector>

#include "core/adjustment/result/session_fit.h"

namespace alidade {

/// The reliability of a number that was entered once and affects all readings of its position or of the
/// session: a pointing zero, the distance, a known radius. The test of misread readings does not cover these
/// inputs and never names them, however large their error.
struct InputReliability {
  Unknown input;          ///< `arc` of a zero is an index into the fitted arcs
  double sigma = 0;       ///< stated, rad or mm; may be 0
  double redundancy = 0;  ///< share of its error that the readings show, 0…1; 0: unchecked
  double perInput = 0;    ///< ∂Δd/∂value as entered, mm per rad or per mm; 0 without an intersection
};

/// Zeros position by position, the radius if known, the distance. A zero is checked only if zeros are
/// estimated because an axis was measured again; the distance never is.
std::vector<InputReliability> reliabilityOfInputs(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
