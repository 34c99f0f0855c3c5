#pragma once

#include <map>
#include <string>
#include <vector>

namespace alidade {

/// The whole number of each point in the session, by its name in the file. Whole numbers of at most nine
/// digits stay. Other names get the number at their end ("P07" is 7) if these numbers are unique; otherwise
/// all names are counted from `first` in the order of their first appearance. Empty names have no number.
std::map<std::string, std::string> pointNumbers(const std::vector<std::string>& names, int first = 1);

}  // namespace alidade
