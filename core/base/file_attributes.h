#pragma once

#include <string>

namespace alidade {

/// Gives the open file `to` the access list and the other extended attributes of the file `from`, where the
/// system grants it; an access list of its own, as from its folder's default, goes. False: `from` has an
/// access list that `to` has not got, so that the rights of a group may mean others.
bool copyFileAttributes(const std::string& from, int to);

}  // namespace alidade
