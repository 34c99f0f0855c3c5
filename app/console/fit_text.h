#pragma once

#include <string>

#include "core/adjustment/result/session_fit.h"
#include "core/answers/fit_answer.h"

namespace alidade::console {

// The fit as text, UTF-8, ending in a newline.

std::string fitText(const FitAnswer& answer);
std::string fitText(const std::string& name, const PublishedSessionFit& fit);

}  // namespace alidade::console
