#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/diagnosis/gap/leftover.h"
#include "core/effects/catalogue.h"

namespace alidade {

// Patterns of no catalogued cause as several sessions may share them: functions of what means the same in
// each, the guideway's coordinate, the circles as they are read, azimuth and elevation, the share of the
// session gone by. Those of a session's own search (`shape_components.h`) follow what one session has in
// common instead.

/// A pattern, as an effect whose id is what it follows. It has no numbers that people would know.
struct SessionPattern {
  Effect effect;
  int order = 0;             ///< periods in a turn; 0: it is no harmonic
  Eigen::Index columns = 1;  ///< a weight of 1 is 0.05 mm along the radius, 5″ of a circle, …
};
const std::vector<SessionPattern>& sessionPatterns();

/// Their visible columns side by side, `leftover.rows()` long; zeros of sessions with more than 20 000
/// readings, which say enough by themselves.
Eigen::MatrixXd patternColumns(const Leftover& leftover, const Measurement& measurement, const JointFit& fit);

}  // namespace alidade
