#include "core/session/session_file.h"

#include <nlohmann/json.hpp>

#include "tests/fuzz/pipeline.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/targets.h"

namespace alidade::fuzz {

namespace {

std::string_view withoutMark(std::string_view bytes) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return bytes.starts_with(mark) ? bytes.substr(mark.size()) : bytes;
}

}  // namespace

void throwSession(std::string_view bytes) {
  const Result<Session> session = readSession(bytes);
  if (!session) return require(!session.problem().what.empty(), "a file refused without words");
  require(nlohmann::json::parse(withoutMark(bytes)) == nlohmann::json::parse(writeSession(*session)),
          "a session that is written with other values than it was read with");
  // Sentences quote typed texts, so these must not contain “nan” or “inf ” themselves.
  if (bytes.find("nan") == bytes.npos && bytes.find("inf ") == bytes.npos) workThrough(*session);
}

}  // namespace alidade::fuzz
