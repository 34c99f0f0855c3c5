#pragma once

#include <string_view>

namespace alidade {

// Are these the first bytes, or is this the beginning of the text, of a file that holds no readings as such?
// By the marks that these formats begin with; for the rows of `fileFormats`.

bool looksLikePdf(std::string_view bytes);
bool looksLikeExcel(std::string_view bytes);         ///< XLSX: a ZIP archive with the parts of a workbook
bool looksLikeOpenDocument(std::string_view bytes);  ///< ODS, ODT: a ZIP archive that names its kind first
bool looksLikeArchive(std::string_view bytes);       ///< ZIP, gzip, 7z, RAR
bool looksLikeOldOffice(std::string_view bytes);     ///< XLS, DOC before 2007
bool looksLikeDatabase(std::string_view bytes);      ///< SQLite, Access
bool looksLikeImage(std::string_view bytes);         ///< PNG, JPEG, GIF, TIFF, BMP, WebP, HEIC
bool looksLikeDrawing(std::string_view bytes);       ///< DWG
bool looksLikeCarlsonCrd(std::string_view bytes);
bool looksLikeNothing(std::string_view bytes);  ///< formats without a mark, known by their suffix only

bool looksLikeDxf(std::string_view text);
bool looksLikeRtf(std::string_view text);
bool looksLikeHtml(std::string_view text);
bool looksLikeOtherXml(std::string_view text);
bool looksLikeJson(std::string_view text);
bool looksLikePostScript(std::string_view text);

/// The name of the element that an XML text begins with, without its prefix; empty where it is no XML.
/// Declarations, comments and document types before it are passed over.
std::string_view xmlRootName(std::string_view text);

}  // namespace alidade
