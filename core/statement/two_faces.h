#pragma once

#include "core/adjustment/result/two_faces.h"
#include "core/statement/statement.h"

namespace alidade {

/// Collimation, trunnion tilt and index with u, in arcseconds, and the scatter of the differences.
Statement instrumentErrors(const TwoFaces& faces);

/// Each visit read in both faces: 2c as read and its deviation from its course, and the index, in arcseconds.
Statement faceDifferences(const Measurement& measurement, const TwoFaces& faces);

}  // namespace alidade
