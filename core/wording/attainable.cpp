#include "core/wording/attainable.h"

#include <utility>

namespace alidade {

namespace {

bool isEasier(const AttainableUncertainty& one, const AttainableUncertainty& other) {
  return std::pair(one.measures.size(), one.expanded) < std::pair(other.measures.size(), other.expanded);
}

}  // namespace

const AttainableUncertainty* easiestMeasured(const std::vector<AttainableUncertainty>& attainable) {
  const AttainableUncertainty* easiest = nullptr;
  for (const AttainableUncertainty& one : attainable)
    if (!one.measures.empty() && (!easiest || isEasier(one, *easiest))) easiest = &one;
  return easiest;
}

}  // namespace alidade
