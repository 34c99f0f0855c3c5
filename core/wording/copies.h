#pragma once

#include <string>

namespace alidade {

// What is said of a file that holds what another one holds. Both are paths; the names of the files tell them
// apart, or else all of the paths.

/// "holds the same readings as a.alidade: counted once", of `copy`.
std::string copyReason(const std::string& copy, const std::string& first);
/// "b.alidade holds the same readings as a.alidade: counted once."
std::string copySentence(const std::string& copy, const std::string& first);

}  // namespace alidade
