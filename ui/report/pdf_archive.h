#pragma once

#include <QDateTime>
#include <QString>
#include <string>
#include <string_view>
#include <vector>

namespace alidade::ui {

/// The metadata of a document.
struct PdfInformation {
  QString title, author, creator;  ///< empty: not stated
  QDateTime date;
};

/// A file inside a document.
struct PdfAttachment {
  QString fileName, description;
  std::string bytes;
  const char* mimeType = "application/json";
  const char* relationship = "/Data";  ///< relationship to the document, of ISO 19005-3: "/Source", "/Data"
};

/// Converts a PDF/A-1b written by Qt to PDF/A-3b (ISO 19005-3), which may contain files. Dates and
/// identifiers follow from the input, so that equal input gives equal bytes. Throws `std::runtime_error` if
/// `pdf` is not a PDF.
std::string archivedPdf(std::string_view pdf, const PdfInformation& information,
                        const std::vector<PdfAttachment>& attachments);

}  // namespace alidade::ui
