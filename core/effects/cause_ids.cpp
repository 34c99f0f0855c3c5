#include "core/effects/cause_ids.h"

#include <algorithm>

#include "core/effects/catalogue.h"

namespace alidade {

const std::vector<std::string>& diagnosableEffects() {
  static const std::vector<std::string> ids = [] {
    std::vector<std::string> list;
    for (const Effect& effect : effectCatalogue()) list.emplace_back(effect.id);
    for (const char* id : {jumpId, grossErrorId, noiseId}) list.emplace_back(id);
    return list;
  }();
  return ids;
}

bool isDiagnosable(std::string_view id, const Measurement& measurement) {
  return std::ranges::find(diagnosableEffects(), id) != diagnosableEffects().end() ||
         effectById(id, measurement) != nullptr;
}

}  // namespace alidade
