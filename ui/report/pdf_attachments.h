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
    Unreadable,  ///< the document itself; `failure` says how
  };
  Outcome outcome = Outcome::NotThere;
  std::string bytes = {};
  std::string failure = {};
};

/// The first file attached to `pdf` whose name ends so, in any case of ASCII letters, if it holds at most
/// `mostBytes`: a few bytes may unfold to very many. Throws `std::bad_alloc` alone.
AttachedFile attachedFile(std::string_view pdf, std::string_view suffix, std::size_t mostBytes);

}  // namespace alidade::ui
