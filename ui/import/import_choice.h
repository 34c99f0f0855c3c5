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

/// How a file was taken, by the user's choice.
struct FileChoice {
  enum class Where {
    Unknown,  ///< still to be chosen
    ByLine,   ///< as the file says
    All,      ///< all of it at `axis`
    Turned,   ///< at 0°, from `turnedAtLine` on at 180°
  };
  Where where = Where::Unknown;
  std::string axis = {};   ///< 0 or 180
  std::string round = {};  ///< of all its rows; empty: as the file says
  std::size_t turnedAtLine = 0;

  bool operator==(const FileChoice&) const = default;
};

/// All that the user chooses of an import before its pointing zeros.
struct ImportChoice {
  std::vector<FileChoice> files;               ///< as many as sources
  std::map<std::string, TableLayout> layouts;  ///< of the tables, by `Recognised::signature`
  std::string zeroPoint = {};
  bool isAdded = false;  ///< to the session at work; else into a new one
};

/// What is proposed: layouts as recognised, the axis from names of files such as `arc 180.gsi`.
ImportChoice proposedChoice(const std::vector<ImportSource>& sources);

/// What an import comes to.
struct ImportReading {
  std::optional<Import> import;          ///< absent: nothing can be imported, as `problem` says
  std::string problem = {};              ///< a sentence
  std::vector<ProblemGroup> kinds = {};  ///< of what cannot be used
  bool hasRounds = false, hasFaces = false, hasSliders = false, hasTilts = false, hasCorrections = false,
       hasNotes = false;
};

/// The files as the core takes them; `sources` keep their bytes.
std::vector<ReadingsFile> filesOf(const std::vector<ImportSource>& sources, const ImportChoice& choice);

/// On any thread: the readings put into `base`.
ImportReading readImport(const std::vector<ImportSource>& sources, const ImportChoice& choice,
                         const Session& base);

}  // namespace alidade::ui
