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
#include "core/session/session.h"

namespace alidade {

/// A file of readings, and what it does not say or what it says in its own way.
struct ReadingsFile {
  std::string name;        ///< for sentences and the journal
  std::string_view bytes;  ///< of somebody who keeps them
  std::string axis = {};   ///< 0 or 180: of all of it, whatever it says; empty: as it says
  std::string round = {};  ///< likewise
  std::optional<std::size_t> turnedAtLine = {};  ///< from this line on the axis stood at 180°, before at 0°,
                                                 ///< where the file does not say how it stood
  std::optional<TableLayout> table = {};  ///< of a table; absent: as the names of its columns say
};

/// What holds for all files of an import.
struct ImportOptions {
  Session base = blankSession();         ///< what the readings are put into; has it readings, they are added
  AngleUnit unit = AngleUnit::Unstated;  ///< of plain numbers in CSV columns that name none
  std::string zeroPoint;                 ///< the point whose sightings are of the pointing zero; empty:
                                         ///< ZERO, in the file of an instrument 0 as well
  std::optional<std::size_t> turnedAtLine;  ///< of a single file, as in `ReadingsFile`
};

/// Where rows of a position were read: row for row, the lines of a file in their order.
struct ImportedRows {
  std::size_t position = 0, firstRow = 0, count = 0;
  std::size_t file = 0;
  std::vector<std::pair<std::size_t, std::size_t>> lines;  ///< first and last of each run, from 1
};

/// A session made of files of readings, or one with their readings added.
struct Import {
  Session session;
  std::string format;    ///< as the readers call it: "GSI-8", "SDR33", "JobXML", "CSV"; of several
                         ///< files all that there are
  std::size_t rows = 0;  ///< of readings that came, excluded ones too
  std::vector<LineProblem> problems;  ///< in the order of the files and lines. Entries that mean nothing are
                                      ///< in the session as they stand; lines that cannot be read are not
  std::vector<std::string> remarks;   ///< sentences: what was taken how, and what was not used
  std::vector<ImportedRows> origins;  ///< of all rows that came, in the order of positions and rows
  std::vector<std::size_t> unplaced;  ///< files that do not say how the axis stood: put at 0°
};

/// The end of the remark on a file of `unplaced`.
inline constexpr const char* putAtZero =
    PHRASE_LATER("Phrase", "nothing in the file says how the axis stood: all its readings are put at 0°");

/// Readings of a theodolite, from the bytes of files of instruments (file_format.h) and tables
/// (csv_reader.h); the content tells which. Sightings of the pointing zero become
/// the zero of their position, several of them as the mean of their face 1 equivalents; a zero that `base`
/// has already stays. Where a file does not say, the face follows from the vertical circle, the round from
/// how often point and face came before in this position (rounds that the file states are passed over), the
/// axis from `turnedAtLine`, else it is 0°. Positions are in the order 0°, 180°, as a session has them read;
/// where `base` has readings, its positions and rows stay, and what comes goes behind them. Point names that
/// are no whole numbers are numbered, the name kept in the note. Fails on what is no text, is of a
/// format that is not read, or holds no readings, and on vertical circles of two kinds.
Result<Import> importReadings(const std::vector<ReadingsFile>& files, const ImportOptions& options = {});

/// The same of a single file, `turnedAtLine` as in the options.
Result<Import> importReadings(std::string_view bytes, const ImportOptions& options = {});

}  // namespace alidade
