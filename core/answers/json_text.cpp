#include "core/answers/json_text.h"

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "core/base/version.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

/// The long form of a name; empty for a name without one.
std::string longNameOf(const std::string& name) {
  if (name == "expanded") return "expanded_uncertainty";
  constexpr std::pair<std::string_view, std::string_view> names[] = {{"u", "standard_uncertainty"},
                                                                     {"dof", "degrees_of_freedom"}};
  for (const auto& [old, replacing] : names)
    if (name == old || name.starts_with(std::string(old) + "_"))
      return std::string(replacing) + name.substr(old.size());
  return "";
}

}  // namespace

std::string answerText(Json document, const std::string& digest) {
  if (!digest.empty()) document["session_sha256"] = digest;
  document["program"] = {{"name", "Alidade"}, {"version", programVersion}, {"build", programBuild}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Json withLongNames(const Json& document) {
  if (!document.is_structured()) return document;
  Json all = document.is_array() ? Json::array() : Json::object();
  for (const auto& [key, value] : document.items()) {
    if (document.is_array()) {
      all.push_back(withLongNames(value));
      continue;
    }
    all[key] = withLongNames(value);
    const std::string longName = longNameOf(key);
    if (!longName.empty() && (value.is_number() || value.is_null())) all[longName] = value;
  }
  return all;
}

}  // namespace alidade
