#include "core/wording/copies.h"

#include <filesystem>

#include "core/base/phrase.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

/// Returns the name of `file`, or its whole path if `other` has the same name.
std::string distinctName(const std::string& file, const std::string& other) {
  const std::filesystem::path name = std::filesystem::path(file).filename();
  return wellFormed(name == std::filesystem::path(other).filename() ? file : name.string());
}

}  // namespace

std::string copyReason(const std::string& copy, const std::string& first) {
  return Phrase::of("holds the same readings as %1: counted once", distinctName(first, copy));
}

std::string copySentence(const std::string& copy, const std::string& first) {
  return Phrase::of("%1 holds the same readings as %2: counted once.", distinctName(copy, first),
                    distinctName(first, copy));
}

}  // namespace alidade
