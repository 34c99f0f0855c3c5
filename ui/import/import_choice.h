#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/exchange/grouped_problems.h"
#include "core/exchange/import.h"
#include "ui/import/import_source.h"

namespace alidade::ui {

/// The user's choice for a file.
struct FileChoice {
  enum class Where {
    Unknown,  ///< still to be chosen
    ByLine,   ///< at the axis angle that the file states for each line
    All,      ///< the whole file at `axis`
    Turned,   ///< at 0°, from `turnedAtLine` on at 180°
  };
  Where where = Where::Unknown;
  std::string axis = {};   ///< 0 or 180
  std::string round = {};  ///< round of all rows of the file; empty: stated in the file
  std::size_t turnedAtLine = 0;

  bool operator==(const FileChoice&) const = default;
};

/// The user's choices for an import, except the pointing zeros.
struct ImportChoice {
  std::vector<FileChoice> files;               ///< one per source
  std::map<std::string, TableLayout> layouts;  ///< layouts of the tables, by `Recognised::signature`
  std::string zeroPoint = {};
  bool isAdded = false;  ///< true: added to the readings of the current session
};

/// The proposed choices: recognised layouts, and the axis angle from file names such as `arc 180.gsi`.
ImportChoice proposedChoice(const std::vector<ImportSource>& sources);

/// The result of an import.
struct ImportReading {
  std::optional<Import> import;          ///< absent: nothing can be imported; `problem` gives the reason
  std::string problem = {};              ///< a sentence
  std::vector<ProblemGroup> kinds = {};  ///< kinds of unusable entries
  bool hasRounds = false, hasFaces = false, hasSliders = false, hasTilts = false, hasCorrections = false,
       hasNotes = false;
};

/// The files with their choices, as input of `importReadings`. The result refers to the bytes in `sources`.
std::vector<ReadingsFile> filesOf(const std::vector<ImportSource>& sources, const ImportChoice& choice);

/// Adds the readings to `base`. May run on any thread.
ImportReading readImport(const std::vector<ImportSource>& sources, const ImportChoice& choice,
                         const Session& base);

}  // namespace alidade::ui
