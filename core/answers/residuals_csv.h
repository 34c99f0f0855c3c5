#pragma once

#include <string>

#include "core/adjustment/result/session_fit.h"
#include "core/session/measurement.h"

namespace alidade {

/// A table with a row for each reading that took part in the fit, in the order taken, slider readings
/// included: where it was read, its residual (observed minus adjusted, right and up positive), its stated σ
/// and how well the others check it. Units are in the names of the columns; a cell is empty where there is no
/// finite number. `fit` is that of the measurement.
std::string residualsCsv(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
