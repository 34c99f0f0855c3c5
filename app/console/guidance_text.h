#pragma once

#include <string>
#include <vector>

#include "core/answers/guidance_answer.h"
#include "core/base/angle_text.h"
#include "core/base/finding.h"
#include "core/diagnosis/plan_review.h"
#include "core/diagnosis/result/sighting_plan.h"

namespace alidade::console {

/// The next and remaining sightings, the sightings to repeat, and when the readings are enough, as text.
std::string guidanceText(const std::string& session, const Guidance& guidance, CircleUnit unit);

/// The review of a plan as text.
std::string planText(const std::string& session, const PlanReview& review,
                     const std::vector<Finding>& findings, const SessionEffort& effort);

/// The review of a plan as one JSON document.
std::string planJson(const std::string& session, const PlanReview& review,
                     const std::vector<Finding>& findings, const Measurement& measurement,
                     const std::string& digest = {});

}  // namespace alidade::console
