#pragma once

#include <string>

#include "core/answers/guidance_answer.h"

namespace alidade {

/// Returns one JSON document.
std::string guidanceJson(const std::string& session, const Guidance& guidance);

}  // namespace alidade
