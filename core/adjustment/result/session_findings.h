#pragma once

#include <vector>

#include "core/adjustment/arc/arc_fit.h"
#include "core/adjustment/result/fit_finding.h"
#include "core/adjustment/result/session_fit.h"

namespace alidade {

/// A finding for each of the two positions that the intersection needs and the measurement lacks.
std::vector<FitFinding> missingPositions(const Measurement& measurement);

/// Problems of the session's model: an unknown effect or parameter, compensator data that cannot be fully
/// used, the published vertical angle.
std::vector<FitFinding> modelFindings(const Measurement& measurement);

/// Findings on the session as a whole: a missing position, radii or centres of one rigid guideway that
/// differ, a known or nominal radius that contradicts the readings, a problem of the model.
std::vector<FitFinding> sessionFindings(const Measurement& measurement, const SessionFit& fit);

/// Findings on an arc that was fitted: no redundancy, the same reading typed twice, scatter that contradicts
/// the stated noise, a short arc, a radius far from the nominal one, no convergence.
std::vector<FitFinding> arcFindings(const Measurement& measurement, const ArcMeasurement& arc,
                                    const ArcFit& fit);

}  // namespace alidade
