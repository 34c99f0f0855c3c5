#pragma once

#include <string_view>

namespace alidade {

// Do the first bytes, or the beginning of a text, belong to the kind of file in the function's name? None of
// these kinds can hold readings directly. The rows of `fileFormats` use these functions.

bool looksLikePdf(std::string_view bytes);
bool looksLikeExcel(std::string_view bytes);         ///< XLSX: a ZIP archive with the parts of a workbook
bool looksLikeOpenDocument(std::string_view bytes);  ///< ODS, ODT: a ZIP archive that states its kind
bool looksLikeArchive(std::string_view bytes);       ///< ZIP, gzip, 7z, RAR
bool looksLikeOldOffice(std::string_view bytes);     ///< XLS, DOC before 2007
bool looksLikeDatabase(std::string_view bytes);      ///< SQLite, Access
bool looksLikeImage(std::string_view bytes);         ///< PNG, JPEG, GIF, TIFF, BMP, WebP, HEIC
bool looksLikeDrawing(std::string_view bytes);       ///< DWG
bool looksLikeCarlsonCrd(std::string_view bytes);
bool looksLikeNothing(std::string_view bytes);  ///< false: for formats known by their suffix only

bool looksLikeDxf(std::string_view text);
bool looksLikeRtf(std::string_view text);
bool looksLikeHtml(std::string_view text);
bool looksLikeOtherXml(std::string_view text);
bool looksLikeJson(std::string_view text);
bool looksLikePostScript(std::string_view text);

/// The name of an XML text's root element, without its prefix; empty if the text is not XML. Declarations,
/// comments and document types before it are skipped.
std::string_view xmlRootName(std::string_view text);

}  // namespace alidade
