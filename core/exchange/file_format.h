#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/exchange/recording.h"

namespace alidade {

/// Everything the programs know of a format of files. Recognition, import, instrument check, help texts and
/// file dialogs follow from the rows of `fileFormats`; a format is added by its row, its reader and a test.
struct FileFormat {
  std::string_view id;                     ///< for programs: "gsi"
  std::string_view name;                   ///< for people: "Leica GSI"
  std::vector<std::string_view> suffixes;  ///< lower case, without a point

  /// Is this the beginning of such a file? Text is UTF-8; of a binary format these are bytes.
  bool (*looksLike)(std::string_view beginning);

  /// The readings of a whole text; null: files of the format are named and refused.
  Recording (*read)(std::string_view text, const std::string& zeroPoint) = nullptr;

  std::string_view kinds = {};    ///< of a format that is read, for help: "Leica GSI-8 and GSI-16"
  const char* reason = nullptr;   ///< of a format that is read: why a file is taken for it
  const char* refusal = nullptr;  ///< else, with %1 for `name`: that it is not read, and what to do instead
  bool isBinary = false;          ///< its files are no text
  bool mayHoldSession = false;    ///< what is opened by such a name is looked into for a session
};

/// All formats but tables, in the order in which they are looked for. A file that is none of them is a table.
std::span<const FileFormat> fileFormats();

/// The format that a UTF-8 text begins like; null where it is none of the table, so that it may be a table.
const FileFormat* formatOfText(std::string_view beginning);

/// Why a file of a format without a reader cannot be imported.
Problem notRead(const FileFormat& format);

/// The text of a file of readings, as `utf8Text`. Files of binary formats fail with the name of their format;
/// `fileName` tells those apart that have no mark of their own, and may be empty.
Result<std::string> readingsText(std::string_view bytes, std::string_view fileName = {});

/// What is read, for a sentence: `Leica GSI-8 and GSI-16, Zeiss and Trimble M5, …, and tables`.
std::string readableKinds();

/// The names of the formats that are read, without tables, and the ones that are recognised and refused.
std::vector<std::string_view> readableFormats();
std::vector<std::string_view> namedFormats();

/// Suffixes of files of readings, tables too; lower case, without a point, each once.
std::vector<std::string_view> readingsSuffixes();

/// Is a file of this suffix (of any case) one of readings, or of a format that is named and refused? Then
/// opening it means importing it, or being told why not.
bool isImportedSuffix(std::string_view suffix);

}  // namespace alidade
