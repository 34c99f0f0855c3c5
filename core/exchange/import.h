#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/exchange/recording.h"
#include "core/session/session.h"

namespace alidade {

/// What a file of readings does not say, or says in its own way.
struct ImportOptions {
  Session base = blankSession();            ///< what the readings are put into; it must have none
  AngleUnit unit = AngleUnit::Unstated;     ///< of plain numbers in CSV columns that name none
  std::string zeroPoint;                    ///< the point whose sightings are of the pointing zero; empty:
                                            ///< ZERO, in a GSI file 0 as well
  std::optional<std::size_t> turnedAtLine;  ///< from this line on the axis stood at 180°, where the file does
                                            ///< not say how it stood
};

/// A session made of a file of readings.
struct Import {
  Session session;
  std::string format;                 ///< "GSI-8", "GSI-16" or "CSV"
  std::size_t rows = 0;               ///< of readings, excluded ones too
  std::vector<LineProblem> problems;  ///< in the order of the lines. Entries that mean nothing are in the
                                      ///< session as they stand; lines that cannot be read are not
  std::vector<std::string> remarks;   ///< sentences: what was taken how, and what was not used
};

/// Readings of a theodolite, from the bytes of a GSI file (gsi_reader.h) or a CSV table (csv_reader.h); the
/// content tells which. Sightings of the pointing zero become the zero of their position, several of them as
/// the mean of their face 1 equivalents; a zero that `base` has already stays. Where the file does not say,
/// the face follows from the vertical circle, the round from how often point and face came before in this
/// position (rounds that the file states are passed over), the axis from `turnedAtLine`, else it is 0°.
/// Positions are in the order 0°, 180°, as a session has them read. Point names that are no whole numbers are
/// numbered, the name kept in the note. Fails on what is no text, is a session, or holds no readings.
Result<Import> importReadings(std::string_view bytes, const ImportOptions& options = {});

}  // namespace alidade
