#include "core/self_test/self_test.h"

#include <algorithm>
#include <iterator>

#include "core/self_test/check_families.h"

namespace alidade {

std::size_t SelfTest::count(SelfCheck::Outcome outcome) const {
  return static_cast<std::size_t>(std::ranges::count(checks, outcome, &SelfCheck::outcome));
}

bool SelfTest::hasPassed() const {
  return count(SelfCheck::Outcome::Failed) == 0 && count(SelfCheck::Outcome::Passed) > 0;
}

SelfTest runSelfTest(const std::string& share, const SelfTestReferences& references) {
  SelfTest test{.checks = {}, .environment = coreEnvironment()};
  for (std::vector<SelfCheck>& family : std::vector<std::vector<SelfCheck>>{
           fitChecks(references.fits), publishedChecks(), diagnosisChecks(),
           distributionChecks(references.numbers), angleChecks(references.numbers),
           randomChecks(references.numbers), installedChecks(share)})
    std::ranges::move(family, std::back_inserter(test.checks));
  return test;
}

}  // namespace alidade
