#pragma once

#include <vector>

#include "core/diagnosis/decision.h"
#include "core/statement/headline.h"

namespace alidade {

/// Whether an expanded uncertainty (mm) is small enough to determine Δd: less than the nominal radius.
bool isDetermined(const Measurement& measurement, double expanded);

/// The lines of small type below the result, in the order of `Headline::Line::Kind`. `decision` belongs to
/// the other arguments and is null without a verdict. A null `diagnosis` means that none was made.
std::vector<Headline::Line> headlineLines(const Measurement& measurement, const SessionFit& fit,
                                          const Diagnosis* diagnosis, const AcceptanceDecision* decision,
                                          const std::vector<Dependence>& dependences);

}  // namespace alidade
