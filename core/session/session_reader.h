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

/// The rows of one position, and the first problem in them.
struct RowsRead {
  std::vector<Reading> readings;
  std::optional<Problem> problem;
};

/// The rows of a session, received one by one from the parser. Rows that differ only in their texts share one
/// origin, whose memory is many times that of a text.
class SessionRows {
 public:
  void add(const Place& where, const nlohmann::ordered_json& row);
  RowsRead take(std::size_t position);

 private:
  std::vector<RowsRead> m_positions;
  JsonOrigin m_last;

  bool isLikeLast(const nlohmann::ordered_json& row) const;
};

/// The session in a parsed file, as `readSession` returns it. `rows`: the rows of all positions, whose lists
/// in `document` are empty.
Result<Session> sessionFromJson(const nlohmann::ordered_json& document, SessionRows rows);

}  // namespace alidade
