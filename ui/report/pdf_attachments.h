#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace alidade::ui {

/// A file inside a document, or why it is unavailable.
struct AttachedFile {
  enum class Outcome {
    Found,
    NotThere,    ///< no attached file has this ending
    Missing,     ///< listed, but without contents
    TooLarge,    ///< larger than the limit
    Damaged,     ///< the file's contents end early or are corrupt
    Exhausting,  ///< the document exceeds the limit of memory or time
    Unreadable,  ///< the document itself is damaged; `failure` says how
  };
  Outcome outcome = Outcome::NotThere;
  std::string bytes = {};
  std::string failure = {};
};

/// Limits for reading a document, since a few compressed bytes may expand to very many.
struct PdfLimits {
  std::size_t mostBytes;  ///< bytes of the attached file
  std::size_t mostMemory = std::size_t{512}
                           << 20;  ///< bytes of memory for reading, besides the document and the file
};

/// The first file attached to `pdf` whose name has this ending, ignoring ASCII case. A separate process reads
/// the document, so a crash or an excess of memory ends only that process. Throws only `std::bad_alloc`.
AttachedFile attachedFile(std::string_view pdf, std::string_view ending, const PdfLimits& limits);

}  // namespace alidade::ui
