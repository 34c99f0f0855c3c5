#include "core/session/session_file.h"

#include <nlohmann/json.hpp>

#include "core/base/file_bytes.h"
#include "core/session/json_text.h"
#include "core/session/session_reader.h"

namespace alidade {

Result<Session> readSession(std::string_view text) {
  nlohmann::ordered_json json;
  SessionRows rows;
  const auto take = [&](const Place& where, const nlohmann::ordered_json& row) { rows.add(where, row); };
  if (auto problem = parseJson(text, json, take)) return *std::move(problem);
  return sessionFromJson(json, std::move(rows));
}

Result<Session> loadSession(const std::string& path) {
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.problem();
  return readSession(*bytes);
}

}  // namespace alidade
