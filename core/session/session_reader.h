#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "core/base/problem.h"
#include "core/base/result.h"
#include "core/session/json_origin.h"
#include "core/session/session.h"

namespace alidade {

/// The rows of one position, and the first thing that is wrong in them.
struct RowsRead {
  std::vector<Reading> readings;
  std::optional<Problem> problem;
};

/// The rows of a session, read one by one as the parser hands them on. Rows that differ in their texts only
/// share one origin, which takes up many times a text's memory.
class SessionRows {
 public:
  void add(const Place& where, const nlohmann::ordered_json& row);
  RowsRead take(std::size_t position);

 private:
  std::vector<RowsRead> m_positions;
  JsonOrigin m_last;

  bool isLikeLast(const nlohmann::ordered_json& row) const;
};

/// The session in a parsed file; `readSession` without the parsing. `rows`: of its positions, whose own lists
/// are empty.
Result<Session> sessionFromJson(const nlohmann::ordered_json& document, SessionRows rows);

}  // namespace alidade
