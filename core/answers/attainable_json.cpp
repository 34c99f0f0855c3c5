#include "core/answers/attainable_json.h"

#include <nlohmann/json.hpp>

#include "core/wording/measure.h"

namespace alidade {

nlohmann::ordered_json attainableJson(const std::vector<AttainableUncertainty>& attainable) {
  auto json = nlohmann::ordered_json::array();
  for (const AttainableUncertainty& one : attainable)
    json.push_back({{"measure", textOf(one.measures)}, {"known", one.known}, {"expanded_mm", one.expanded}});
  return json;
}

}  // namespace alidade
