#pragma once

#include <string>

#include "core/adjustment/result/session_fit.h"
#include "core/answers/fit_answer.h"
#include "core/session/measurement.h"

namespace alidade::console {

// The fit as text, UTF-8, ending in a newline. Lengths in mm, y up. The published method is shown in its
// published form, next to the equivalent circle in this program's frame.

std::string fitText(const FitAnswer& answer);
std::string fitText(const std::string& name, const Measurement& measurement, const PublishedSessionFit& fit);

}  // namespace alidade::console
