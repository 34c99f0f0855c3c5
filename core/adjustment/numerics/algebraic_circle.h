#pragma once

#include <optional>
#include <vector>

#include "core/observation/guideway.h"

namespace alidade {

/// The circle that minimises Σ (x² + y² − 2ax − 2by − c)² (Kåsa's fit). The closed form needs no start, but
/// is biased towards small radii on short noisy arcs: it serves only as a start. Points in mm. Absent if the
/// points determine no circle: fewer than three, or all on a straight line to rounding error. Source: I.
/// Kåsa, "A circle fitting procedure and its error analysis", IEEE Trans. Instrum. Meas. 25 (1976).
std::optional<Circle> algebraicCircle(const std::vector<PlanePoint<double>>& points);

}  // namespace alidade
