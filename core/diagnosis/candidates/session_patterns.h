#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/diagnosis/gap/leftover.h"
#include "core/effects/catalogue.h"

namespace alidade {

// Patterns without a catalogued cause that several sessions may share. Their arguments mean the same in each
// session: guideway coordinate, circle readings, azimuth, elevation, fraction of the session's duration. The
// patterns of a session's own search (`shape_components.h`) may use any property of that session.

/// A pattern in the form of an effect. The identifier names the argument; the effect has no parameters.
struct SessionPattern {
  Effect effect;
  int order = 0;             ///< periods in a turn; 0 if the pattern is not harmonic
  Eigen::Index columns = 1;  ///< number of columns; a weight of 1 is 0.05 mm of the radius, 5″ of a circle, …
};
const std::vector<SessionPattern>& sessionPatterns();

/// Returns the visible columns of the patterns side by side, `leftover.rows()` long. They are zero for
/// sessions with more than 20 000 readings, whose own readings suffice for the search.
Eigen::MatrixXd patternColumns(const Leftover& leftover, const Measurement& measurement, const JointFit& fit);

}  // namespace alidade
