#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/gross_errors/entry_errors.h"
#include "core/base/problem.h"
#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade {

/// A new text for one cell of the table of readings.
struct CellChange {
  Place where;  ///< position, reading and field: "horizontal", "vertical", "slider" or "face"
  std::string text;
  std::string typed = {};  ///< current text

  bool operator==(const CellChange&) const = default;
};

/// A reading that may have been intended in a row, one entry error away from the typed text.
struct Correction {
  EntryError error = EntryError::OneDigitWrong;
  double prior = 0;                          ///< frequency of such an error, before any reading
  std::vector<CellChange> changes;           ///< made together; never empty
  std::map<std::size_t, Reading> rows = {};  ///< the changed rows of the position after the correction
};

/// All possible intended readings of a row, whether or not they can be used.
std::vector<Correction> correctionsOf(const Session& session, std::size_t position, std::size_t row);

/// Converts one row to a sighting, independently of all others.
class RowReader {
 public:
  explicit RowReader(const Session& session);

  /// Empty if the row, the pointing zero or the rest of the session cannot be used.
  std::optional<Sighting> read(std::size_t position, std::size_t row, const Reading& reading);

 private:
  std::vector<std::size_t> m_firstSequences;  ///< of each position
  Session m_alone;                            ///< the session with one row
};

}  // namespace alidade
