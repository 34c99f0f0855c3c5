#pragma once

#include <vector>

#include "core/adjustment/result/session_fit.h"

namespace alidade {

/// How well a number is checked that was entered once, and that all readings of its position or of the
/// session are reckoned with: a pointing zero, the distance, a known radius. The test of misread readings is
/// not of these, so no error of theirs, however large, is named by it.
struct InputReliability {
  Unknown input;          ///< its arc, of a zero, counts those fitted
  double sigma = 0;       ///< stated, rad or mm; may be 0
  double redundancy = 0;  ///< share of its error that shows against its own σ, 0…1; 0: nothing checks it
  double perInput = 0;    ///< ∂Δd/∂value as entered, mm per rad or per mm; 0 without an intersection
};

/// Zeros position by position, the radius where it is known, the distance. A zero is checked only where zeros
/// are estimated, since an axis was measured again; the distance never is.
std::vector<InputReliability> reliabilityOfInputs(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
