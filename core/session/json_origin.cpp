#include "core/session/json_origin.h"

#include <nlohmann/json.hpp>

namespace alidade {

JsonOrigin::JsonOrigin(const nlohmann::ordered_json& object)
    : m_object(std::make_shared<const nlohmann::ordered_json>(object)) {}

const nlohmann::ordered_json& JsonOrigin::object() const {
  static const nlohmann::ordered_json empty = nlohmann::ordered_json::object();
  return m_object ? *m_object : empty;
}

}  // namespace alidade
