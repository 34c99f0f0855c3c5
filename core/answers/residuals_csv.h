#pragma once

#include <string>

#include "core/adjustment/result/session_fit.h"
#include "core/session/measurement.h"

namespace alidade {

/// Returns a table with a row for each reading of the fit, slider readings included, in the order in which
/// they were taken. It states where the reading was taken and its residual (observed minus adjusted, right
/// and up positive). It also states σ and how well other readings check it. Column names contain the units; a
/// cell is empty if its number is not finite. `fit` is that of the measurement.
std::string residualsCsv(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
