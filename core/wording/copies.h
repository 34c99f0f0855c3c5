#pragma once

#include <string>

namespace alidade {

// Sentences on a file `copy` with the same readings as the file `first`. Both parameters are paths. The
// sentences use the file names, or the whole paths if the names are equal.

/// "holds the same readings as a.alidade: counted once"; the subject is `copy`.
std::string copyReason(const std::string& copy, const std::string& first);
/// "b.alidade holds the same readings as a.alidade: counted once."
std::string copySentence(const std::string& copy, const std::string& first);

}  // namespace alidade
