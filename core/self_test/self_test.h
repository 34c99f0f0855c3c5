#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/self_test/references.h"
#include "core/self_test/self_check.h"

namespace alidade {

// Does this installation, on this machine, give the right results? Every number is compared with one
// calculated without this program. Fits are calculated at 60 digits, distributions and angles at 50. Random
// numbers and a simulated session are from an implementation in another language. Other references are the
// figures printed in the paper and in JCGM 100, and sessions of a known truth. For a quality manual each line
// has the expected and the found value, their difference, its limit and reason, with the machine and the
// libraries.

/// Name and value of everything that may affect a result: program, compiler, libraries, processor, system.
using EnvironmentFacts = std::vector<std::pair<std::string, std::string>>;

/// Facts on the libraries of the core, and on the machine.
EnvironmentFacts coreEnvironment();

struct SelfTest {
  std::vector<SelfCheck> checks;  ///< group by group
  EnvironmentFacts environment;

  std::size_t count(SelfCheck::Outcome outcome) const;
  /// Did at least one check run, and none fail?
  bool hasPassed() const;
};

/// All checks that need no window. `share` is the folder of the program's installed files; if it is empty,
/// the check of these files is left out. Writes nothing. Takes a second on a usual machine.
SelfTest runSelfTest(const std::string& share, const SelfTestReferences& references = compiledReferences());

/// The folder `share` next to the folder `bin` of the running program; empty if it has no `alidade` folder.
std::string installedShare();

/// {"at", "verdict": "pass"|"fail", "passed", "failed", "left_out", "environment": {name: value},
/// "checks": [{"group", "name", "expected", "found", "deviation", "tolerance", "reason", "outcome": "passed"|
/// "failed"|"left-out"}], "program": {"name", "version", "build"}}. `deviation` and `tolerance` are relative
/// to `expected`, and null for values that are not numbers.
std::string selfTestJson(const SelfTest& test, const std::string& at);

}  // namespace alidade
