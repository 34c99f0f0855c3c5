#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/gross_errors/entry_slips.h"
#include "core/base/place.h"
#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade {

/// A new text for one cell of the table of readings.
struct CellChange {
  Place where;  ///< position, reading and field: "horizontal", "vertical", "slider" or "face"
  std::string text;
  std::string typed = {};  ///< what stands there now

  bool operator==(const CellChange&) const = default;
};

/// A way in which a row may have been meant, one slip away from what was typed.
struct Correction {
  EntrySlip slip = EntrySlip::OneDigitWrong;
  double prior = 0;                          ///< how often such a slip is, before anything is known
  std::vector<CellChange> changes;           ///< all of them together; never empty
  std::map<std::size_t, Reading> rows = {};  ///< the changed rows of the position as they would be
};

/// Everything that a row of a position may have been meant to be, whether or not it can be used.
std::vector<Correction> correctionsOf(const Session& session, std::size_t position, std::size_t row);

/// What one row means, apart from all others.
class RowReader {
 public:
  explicit RowReader(const Session& session);

  /// Empty where the row, the pointing zero or the rest of the session cannot be used.
  std::optional<Sighting> read(std::size_t position, std::size_t row, const Reading& reading);

 private:
  std::vector<std::size_t> m_firstSequences;  ///< of each position
  Session m_alone;                            ///< the session with one row
};

}  // namespace alidade
