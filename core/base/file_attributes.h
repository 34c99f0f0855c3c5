#pragma once

#include <string>

namespace alidade {

/// Copies the access list and the other extended attributes of the file `from` to the open file `to`, if the
/// system allows it. An access list that `to` inherited from its folder is removed. False: `from` has an
/// access list that `to` lacks, so that group rights may apply to other users.
bool copyFileAttributes(const std::string& from, int to);

}  // namespace alidade
