#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace alidade::ui {

/// A file inside a document, or why it cannot be had.
struct AttachedFile {
  enum class Outcome {
    Found,
    NotThere,    ///< no attached file has such a name
    Missing,     ///< its name is there, what it holds is not
    TooLarge,    ///< holds more than was to be taken
    Damaged,     ///< ends or goes wrong within
    Exhausting,  ///< the document takes more memory or time than was given
    Unreadable,  ///< the document itself; `failure` says how
  };
  Outcome outcome = Outcome::NotThere;
  std::string bytes = {};
  std::string failure = {};
};

/// What may be spent on a document, whatever is in it: a few bytes may unfold to very many.
struct PdfLimits {
  std::size_t mostBytes;                            ///< of the attached file
  std::size_t mostMemory = std::size_t{512} << 20;  ///< for the document beside its own bytes and the file
};

/// The first file attached to `pdf` whose name ends so, in any case of ASCII letters. The document is read in
/// a process of its own, which ends where it takes more than the limits or breaks down. Throws
/// `std::bad_alloc` alone.
AttachedFile attachedFile(std::string_view pdf, std::string_view ending, const PdfLimits& limits);

}  // namespace alidade::ui
