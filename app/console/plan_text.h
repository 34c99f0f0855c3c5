#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/diagnosis/plan_review.h"
#include "core/diagnosis/result/sighting_plan.h"

namespace alidade::console {

/// The review of a plan as text.
std::string planText(const std::string& session, const PlanReview& review,
                     const std::vector<Finding>& findings, const SessionEffort& effort);

/// The review of a plan as one JSON document.
std::string planJson(const std::string& session, const PlanReview& review,
                     const std::vector<Finding>& findings, const Measurement& measurement);

}  // namespace alidade::console
