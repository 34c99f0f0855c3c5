#include "core/diagnosis/search/search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/candidates/gross_error_components.h"
#include "core/diagnosis/candidates/jump_components.h"
#include "core/diagnosis/search/inquiry.h"
#include "core/simulation/simulate.h"

namespace alidade {
namespace {

/// A clearly visible trunnion tilt, a small jump and a reading wrong by some σ.
class SearchTest : public testing::TestWithParam<std::string> {
 protected:
  static Leftover leftoverBy(const std::string& protocol) {
    Truth truth = drawTruth(31);
    truth.effects = {{ErrorTerm::TrunnionTilt, 5 * effectById("trunnion_tilt")->parameters[0].plausible}};
    truth.jump = {
        .moment = 0.4, .horizontal = Angle::fromArcseconds(6), .vertical = Angle::fromArcseconds(-3)};
    truth.grossErrors = {
        {.axisDeg = 180, .point = 5, .horizontal = Angle::fromArcseconds(13), .vertical = Angle()}};
    const Session session = *simulate(*protocolByName(protocol), truth, 31);
    const GapModel model = *modelOf(*examine(session).measurement);
    return Leftover(linearise(*model.measurement, *model.fit, model.options));
  }
  static Candidates candidatesFor(const Leftover& leftover) {
    Candidates candidates;
    candidates.add(effectComponents(leftover, {}), 0.04);
    candidates.add(jumpComponents(leftover), 1e-3, {.offered = 2, .oneAtMost = true});
    candidates.add(grossErrorComponents(leftover), 1e-3, {.offered = 4});
    return candidates;
  }

  Leftover leftover = leftoverBy(GetParam());
  Candidates candidates = candidatesFor(leftover);

  bool isJump(std::size_t component) const { return candidates[component].isJump(); }
  bool isGrossError(std::size_t component) const { return candidates[component].grossErrorAt().has_value(); }

  /// The few largest evidences among all jumps or gross errors that may be sought, each added after `before`.
  template <typename Kind>
  std::vector<double> bestByTrying(Search& search, const Kind& isOfKind,
                                   const std::vector<std::size_t>& before, double variance,
                                   std::size_t count) const {
    std::vector<double> all;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (!isOfKind(i) || candidates[i].onlyRow()) continue;
      if (isGrossError(i) && leftover.redundancy(*candidates[i].grossErrorAt()) < 1e-3) continue;
      std::vector<std::size_t> set = before;
      set.push_back(i);
      all.push_back(search.madeOf(set, variance).logBayesFactor);
    }
    std::ranges::sort(all, std::greater{});
    all.resize(std::min(count, all.size()));
    return all;
  }

  /// The evidences of the found sets that consist of `before` and one more component of the kind.
  template <typename Kind>
  static std::vector<double> found(const std::vector<Explanation>& sets, const Kind& isOfKind,
                                   const std::vector<std::size_t>& before) {
    std::vector<double> evidences;
    for (const Explanation& set : sets)
      if (set.parts.size() == before.size() + 1 && isOfKind(set.parts.back().component) &&
          std::equal(before.begin(), before.end(), set.parts.begin(),
                     [](std::size_t component, const Part& part) { return part.component == component; }))
        evidences.push_back(set.logBayesFactor);
    std::ranges::sort(evidences, std::greater{});
    return evidences;
  }

  void expectTheBest(const std::vector<std::size_t>& before, double variance) const {
    const SearchOptions options{.beam = 1000, .mostParts = before.size() + 1, .mostGrossErrors = 1};
    Search search(leftover, candidates, options);
    const std::vector<Explanation> sets = search.grown(variance);
    const auto jumps = [&](std::size_t i) { return isJump(i); };
    const auto grossErrors = [&](std::size_t i) { return isGrossError(i); };
    // The same sums in a different order: rounding errors.
    EXPECT_THAT(
        found(sets, jumps, before),
        testing::Pointwise(testing::DoubleNear(1e-9), bestByTrying(search, jumps, before, variance, 2)));
    EXPECT_THAT(found(sets, grossErrors, before),
                testing::Pointwise(testing::DoubleNear(1e-9),
                                   bestByTrying(search, grossErrors, before, variance, 4)));
  }
};

// An upper bound of the gain decides which jumps and readings are evaluated. The best ones must still be
// those that trying all of them gives.
TEST_P(SearchTest, OffersTheBestOfAllJumpsAndMisreadings) {
  for (const double variance : {1.0, 9.0}) {
    SCOPED_TRACE(variance);
    expectTheBest({}, variance);
    std::size_t tilt = 0;
    while (candidates[tilt].id() != "trunnion_tilt") ++tilt;
    expectTheBest({tilt}, variance);
  }
}

INSTANTIATE_TEST_SUITE_P(Protocols, SearchTest, testing::Values("paper-slider", "two-face", "full"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace alidade
