#include "core/self_test/self_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"

namespace alidade {

const char* nameOf(CheckGroup group) {
  switch (group) {
    case CheckGroup::Fits:
      return "fits";
    case CheckGroup::Published:
      return "published";
    case CheckGroup::Diagnosis:
      return "diagnosis";
    case CheckGroup::Distributions:
      return "distributions";
    case CheckGroup::Angles:
      return "angles";
    case CheckGroup::Random:
      return "random";
    case CheckGroup::Installed:
      return "installed";
    case CheckGroup::Window:
      break;
  }
  return "window";
}

SelfCheck numberCheck(CheckGroup group, std::string name, const std::string& expected, double found,
                      const CheckTolerance& tolerance) {
  SelfCheck check{.group = group,
                  .name = std::move(name),
                  .expected = expected,
                  .found = shortestText(found),
                  .reason = tolerance.reason};
  const Result<double> number = parseNumber(expected);
  if (!number) return check;
  const double size = std::max(std::abs(*number), std::numeric_limits<double>::min());
  check.deviation = std::abs(found - *number) / size;
  check.tolerance = std::max(tolerance.absolute / size, tolerance.relative);
  if (*check.deviation <= *check.tolerance) check.outcome = SelfCheck::Outcome::Passed;
  return check;
}

SelfCheck textCheck(CheckGroup group, std::string name, std::string expected, std::string found,
                    const char* reason) {
  const auto outcome = expected == found ? SelfCheck::Outcome::Passed : SelfCheck::Outcome::Failed;
  return {.group = group,
          .name = std::move(name),
          .expected = std::move(expected),
          .found = std::move(found),
          .reason = reason,
          .outcome = outcome};
}

SelfCheck hashCheck(CheckGroup group, std::string name, const std::string& expected, const std::string& found,
                    const char* reason) {
  constexpr std::size_t shown = 16;
  const auto shortened = [](const std::string& text) {
    return text.size() == 64 ? text.substr(0, shown) + "…" : text;
  };
  SelfCheck check = textCheck(group, std::move(name), expected, found, reason);
  check.expected = shortened(expected);
  check.found = shortened(found);
  return check;
}

SelfCheck brokenCheck(CheckGroup group, std::string name, std::string why) {
  return {.group = group,
          .name = std::move(name),
          .found = std::move(why),
          .reason = PHRASE_LATER("Phrase", "the check could not be made")};
}

}  // namespace alidade
