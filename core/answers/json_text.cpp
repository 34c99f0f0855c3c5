#include "core/answers/json_text.h"

#include <nlohmann/json.hpp>

#include "core/base/version.h"

namespace alidade {

std::string answerText(nlohmann::ordered_json document) {
  document["program"] = {{"name", "Alidade"}, {"version", programVersion}, {"build", programBuild}};
  return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace alidade
