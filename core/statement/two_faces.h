#pragma once

#include "core/adjustment/result/two_faces.h"
#include "core/statement/statement.h"

namespace alidade {

/// Collimation, trunnion tilt and index with u, in arcseconds, and the scatter of the differences.
Statement instrumentErrors(const TwoFaces& faces);

/// Each visit read in both faces: its elevation (°), 2c as read, the residual of 2c, and the index (″).
Statement faceDifferences(const Measurement& measurement, const TwoFaces& faces);

}  // namespace alidade
