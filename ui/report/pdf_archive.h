#pragma once

#include <QDateTime>
#include <QString>
#include <string>
#include <string_view>
#include <vector>

namespace alidade::ui {

/// What a document says of itself.
struct PdfInformation {
  QString title, author, creator;  ///< empty: not stated
  QDateTime date;
};

/// A file inside a document.
struct PdfAttachment {
  QString fileName, description;
  std::string bytes;
  const char* mimeType = "application/json";
  const char* relationship = "/Data";  ///< to the document, of ISO 19005-3: "/Source", "/Data"
};

/// A document as Qt writes it, a PDF/A-1b, as PDF/A-3b (ISO 19005-3), which may hold files. Dates and
/// identifiers follow from what is given: the same is the same to the byte. Throws `std::runtime_error` where
/// `pdf` is none.
std::string archivedPdf(std::string_view pdf, const PdfInformation& information,
                        const std::vector<PdfAttachment>& attachments);

}  // namespace alidade::ui
