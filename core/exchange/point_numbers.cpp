#include "core/exchange/point_numbers.h"

#include <algorithm>
#include <set>

#include "core/base/number_text.h"
#include "core/base/typed_text.h"

namespace alidade {

namespace {

constexpr std::size_t mostDigits = 9;

bool isNumber(const std::string& name) {
  return name.size() <= mostDigits && std::all_of(name.begin(), name.end(), isDigit);
}

/// The whole number at the end of a name, without leading zeros; empty if it has none.
std::string endingNumber(const std::string& name) {
  const std::size_t start = name.find_last_not_of("0123456789") + 1;
  const Result<int> number = parseWhole(name.substr(start));
  return number ? std::to_string(*number) : std::string();
}

}  // namespace

std::map<std::string, std::string> pointNumbers(const std::vector<std::string>& names, int first) {
  std::vector<std::string> distinct;
  std::set<std::string> known;
  for (const std::string& name : names)
    if (!name.empty() && known.insert(name).second) distinct.push_back(name);

  std::map<std::string, std::string> numbers;
  std::set<std::string> taken;
  bool unique = true;
  for (const std::string& name : distinct) {
    numbers[name] = isNumber(name) ? name : endingNumber(name);
    unique = unique && !numbers[name].empty() && taken.insert(numbers[name]).second;
  }
  if (unique || std::all_of(distinct.begin(), distinct.end(), isNumber)) return numbers;
  for (std::size_t i = 0; i < distinct.size(); ++i)
    numbers[distinct[i]] = std::to_string(i + static_cast<std::size_t>(first));
  return numbers;
}

}  // namespace alidade
