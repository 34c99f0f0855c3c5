#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/exchange/recording.h"

namespace alidade {

/// All that the programs know about a file format. Recognition, import, instrument check, help texts and file
/// dialogs use the rows of `fileFormats`; a new format needs a row, a reader and a test.
struct FileFormat {
  std::string_view id;                     ///< for programs: "gsi"
  std::string_view name;                   ///< for people: "Leica GSI"
  std::vector<std::string_view> suffixes;  ///< lower case, without a point

  /// Does a file of the format begin like this UTF-8 text, or like these bytes if the format is binary?
  bool (*looksLike)(std::string_view beginning);

  /// Reads the whole text; null: files of the format are named and refused.
  Recording (*read)(std::string_view text, const std::string& zeroPoint) = nullptr;

  std::string_view kinds = {};    ///< what is read, for help: "Leica GSI-8 and GSI-16"
  const char* reason = nullptr;   ///< if the format is read: how it was recognised
  const char* refusal = nullptr;  ///< if the format is not read: the refusal, %1 for `name`, and the remedy
  bool isBinary = false;          ///< the bytes are not text
  bool mayHoldSession = false;    ///< a file with one of the suffixes is searched for a session
};

/// All formats except tables, in the order in which they are tried. A file that matches none is a table.
std::span<const FileFormat> fileFormats();

/// The format whose beginning matches the UTF-8 text; null if none does, so that the text may be a table.
const FileFormat* formatOfText(std::string_view beginning);

/// The problem of a file whose format has no reader.
Problem notRead(const FileFormat& format);

/// The text of a file of readings, converted by `utf8Text`. Files of binary formats fail with the name of
/// their format; `fileName`, which may be empty, identifies formats without a mark of their own.
Result<std::string> readingsText(std::string_view bytes, std::string_view fileName = {});

/// The readable formats, for a sentence: `Leica GSI-8 and GSI-16, Zeiss and Trimble M5, …, and tables`.
std::string readableKinds();

/// The names of the formats that are read, except tables.
std::vector<std::string_view> readableFormats();

/// Suffixes of files of readings, tables included; lower case, without a point, each once.
std::vector<std::string_view> readingsSuffixes();

/// Does this suffix (in any case) belong to readings, or to a format that is named and refused? Opening a
/// file with the suffix imports the file or says why it cannot be read.
bool isImportedSuffix(std::string_view suffix);

}  // namespace alidade
