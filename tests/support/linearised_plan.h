#pragma once

#include "core/diagnosis/observability/further_readings.h"

namespace alidade::test {

/// Linearises a set that is small enough for one piece.
inline Linearised linearisedPlan(const GapModel& model, const Measurement& set,
                                 const std::vector<ErrorTerm>& terms = everyTerm()) {
  Linearised whole;
  linearisePlan(model, set, terms, [&](const Linearised& piece) { whole = piece; });
  return whole;
}

}  // namespace alidade::test
