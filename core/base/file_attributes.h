#pragma once

#include <string>

namespace alidade {

/// Copies the access list and the other extended attributes of the file `from` to the open file `to`, if the
/// system allows it. An access list that `to` inherited from its folder is removed. False if `to` lacks the
/// access list of `from`: the group bits of the mode, the list's mask, must then not be copied.
bool copyFileAttributes(const std::string& from, int to);

}  // namespace alidade
