#include "core/session/row_order.h"

#include "core/session/entry.h"

namespace alidade {

std::vector<std::size_t> firstSequences(const Session& session) {
  const auto isFirst = [](const Position& position) {
    const Result<int> axis = axisEntry(position.axisDeg);
    return axis && *axis == 0;
  };
  std::vector<std::size_t> first(session.positions.size());
  std::size_t rows = 0;
  for (const bool wanted : {true, false})
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (isFirst(session.positions[i]) != wanted) continue;
      first[i] = rows;
      rows += session.positions[i].readings.size();
    }
  return first;
}

}  // namespace alidade
