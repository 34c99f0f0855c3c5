#pragma once

#include <string>

#include "core/diagnosis/plan_review.h"

namespace alidade::console {

/// The review of a plan for people.
std::string planText(const std::string& session, const PlanReview& review);

/// One JSON document.
std::string planJson(const std::string& session, const PlanReview& review);

}  // namespace alidade::console
