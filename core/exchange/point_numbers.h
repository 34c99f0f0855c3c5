#pragma once

#include <map>
#include <string>
#include <vector>

namespace alidade {

/// The whole number a session calls each point by its name in the file. Whole numbers of at most nine digits
/// stay. Where there are other names, each gets the number it ends with ("P07" is 7), if these differ and are
/// no other point's; otherwise all names are counted from `first` in the order of their first appearance.
/// Empty names have no number.
std::map<std::string, std::string> pointNumbers(const std::vector<std::string>& names, int first = 1);

}  // namespace alidade
