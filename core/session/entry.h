#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/angle.h"
#include "core/base/result.h"
#include "core/session/measurement.h"

namespace alidade {

// The rules for single entries: what a text in one field may be and what an empty one stands for. `field` is
// named as for `entryProblem`; asking for a field of another kind is a bug.

/// A number in the unit of its field, in range. Empty text is the field's default, or nothing where it has
/// none.
Result<std::optional<double>> numberEntry(std::string_view field, const std::string& text);

/// `readings.point`, `readings.round` or `readings.face`; nothing for an empty point.
Result<std::optional<int>> wholeEntry(std::string_view field, const std::string& text);

/// A reading, zero or slider coordinate in the range of its circle; nothing for an empty slider.
Result<std::optional<Angle>> angleEntry(std::string_view field, const std::string& text,
                                        VerticalCircle circle);

/// 0 or 180.
Result<int> axisEntry(const std::string& text);

Result<VerticalCircle> verticalCircleEntry(const std::string& text);
Result<VerticalAngleRelation> verticalAngleEntry(const std::string& text);
Result<RadiusModel> radiusModelEntry(const std::string& text);

/// Why `text` is no date; an empty one is allowed.
std::optional<Problem> dateProblem(const std::string& text);

}  // namespace alidade
