#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/self_test/references.h"
#include "core/self_test/self_check.h"

namespace alidade {

// Does this installation, on this machine, give the results it should? Every number is compared with one that
// was worked out without this program: fits at 60 digits, distributions and angles at 50, random numbers and
// a simulated session written a second time in another language, the figures printed in the paper and in JCGM
// 100, sessions of a known truth. For a quality manual: what was expected, what was found, how far that is
// apart and may be, and why, line by line, with the machine and the libraries.

/// Name and value of what a result may hang on: program, compiler, libraries, processor, system.
using EnvironmentFacts = std::vector<std::pair<std::string, std::string>>;

/// Of the libraries of the core, and of the machine.
EnvironmentFacts coreEnvironment();

struct SelfTest {
  std::vector<SelfCheck> checks;  ///< group by group
  EnvironmentFacts environment;

  std::size_t count(SelfCheck::Outcome outcome) const;
  /// Nothing failed, and something was checked.
  bool hasPassed() const;
};

/// Everything that needs no window. `share` is the folder in which the program's files are installed; empty:
/// it is not installed, and they are left out. Writes nothing. A second on a usual machine.
SelfTest runSelfTest(const std::string& share, const SelfTestReferences& references = compiledReferences());

/// `share` of the prefix in which the running program stands in `bin`, where it holds the samples; else
/// empty.
std::string installedShare();

}  // namespace alidade
