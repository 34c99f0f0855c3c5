#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/phrase.h"
#include "core/base/result.h"
#include "core/exchange/recording.h"
#include "core/exchange/table_layout.h"
#include "core/session/journal.h"
#include "core/session/session.h"

namespace alidade {

/// A file of readings, and what the user states about it.
struct ReadingsFile {
  std::string name;                              ///< name in sentences and in the journal
  std::string_view bytes;                        ///< owned by the caller
  std::string axis = {};                         ///< axis of all rows, 0 or 180; empty: as the file states
  std::string round = {};                        ///< round of all rows; empty: as the file states
  std::optional<std::size_t> turnedAtLine = {};  ///< if no axis is stated: 180° from this line on, 0° before
  std::optional<TableLayout> table = {};         ///< layout of a table; absent: as its column names say
};

/// Options for all files of an import.
struct ImportOptions {
  Session base = blankSession();         ///< session to which the readings are added, after its own
  AngleUnit unit = AngleUnit::Unstated;  ///< unit of plain numbers in columns whose heading states none
  std::string zeroPoint;                 ///< name of the zero; empty: ZERO, in instrument files also 0
};

/// The source of the rows of a position: the lines of a file, in row order.
struct ImportedRows {
  std::size_t position = 0, firstRow = 0, count = 0;
  std::size_t file = 0;
  std::vector<std::pair<std::size_t, std::size_t>> lines;  ///< first and last line of each run, from 1
};

/// A session made from files of readings, or an existing session with the readings added.
struct Import {
  Session session;
  std::string format;                 ///< all formats of the files: "GSI-8", "SDR33", "JobXML", "CSV"
  std::size_t rows = 0;               ///< number of imported rows, excluded ones included
  std::vector<LineProblem> problems;  ///< in the order of files and lines. Invalid entries are in the session
                                      ///< as read; unreadable lines are not
  std::vector<std::string> remarks;   ///< sentences on assumptions and on what was not used
  std::vector<ImportedRows> origins;  ///< sources of all imported rows, in the order of positions and rows
  std::vector<std::size_t> unplaced;  ///< indices of files without an axis, put at 0°
  /// The remark that no sighting has the name `ImportOptions::zeroPoint`; empty if one has, or none is
  /// stated.
  std::string missingZeroPoint = {};
};

/// The end of the remark on a file in `unplaced`.
inline constexpr const char* putAtZero = PHRASE_LATER(
    "Phrase", "the file does not state the position of the axis: all its readings are assigned to 0°");

/// Imports theodolite readings from the bytes of instrument files (file_format.h) and tables (csv_reader.h);
/// the content decides the format. Sightings of the pointing zero become the zero of their position, each in
/// its place by face and time (recorded_zero.h). A zero that `base` already has stays. A face that the
/// file does not state follows from the vertical circle. A missing round follows from earlier sightings of
/// the same point and face in the position, skipping stated rounds. A missing axis follows from
/// `turnedAtLine`, else it is 0°. Positions are in the order 0°, 180°; if `base` has readings, its positions
/// and rows stay and new rows follow them. Points without whole numbers as names are numbered, with the name
/// in the note. Fails on files that are not text, have an unreadable format or hold no readings, and on
/// vertical circles of two kinds.
Result<Import> importReadings(const std::vector<ReadingsFile>& files, const ImportOptions& options = {});

/// Line ranges such as `2–18, 20, 22–30`; of more than twenty ranges, the first twenty and the last line.
std::string linesText(const ImportedRows& rows);

/// A file that was imported.
struct ImportedFile {
  std::string name, sha256;  ///< name, and SHA-256 of the file's bytes
};

/// One entry for the rows of each file in each position, without time, operator and hash. It states the lines
/// of the rows in the file, in row order, and the file's SHA-256. `files`: those of the import.
std::vector<JournalEntry> importEntries(const Import& import, const std::vector<ImportedFile>& files);

}  // namespace alidade
