#include "core/effects/cause_ids.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/effects/catalogue.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

using testing::Contains, testing::IsSupersetOf;

TEST(CauseIds, AreThoseOfTheCatalogueAndThreeMore) {
  const std::vector<std::string>& ids = diagnosableEffects();
  const std::set<std::string> once(ids.begin(), ids.end());
  EXPECT_EQ(once.size(), ids.size()) << "an id stands there twice";
  EXPECT_EQ(ids.size(), effectCatalogue().size() + 3);
  for (const Effect& effect : effectCatalogue()) EXPECT_THAT(ids, Contains(std::string(effect.id)));
  for (const char* id : {jumpId, grossErrorId, noiseId}) {
    EXPECT_THAT(ids, Contains(id));
    EXPECT_FALSE(effectById(id)) << id << " is made up of error terms";
  }
}

// The ray tracer uses the same ids, in files that outlive every version of this program.
TEST(CauseIds, AreThoseOfTruthFiles) {
  std::set<std::string> kinds;
  for (const test::Trial& trial : test::trials()) {
    kinds.insert(trial.kind);
    kinds.insert(trial.lookAlikes.begin(), trial.lookAlikes.end());
  }
  EXPECT_THAT(kinds, IsSupersetOf({jumpId, grossErrorId, noiseId, relationId}));
  for (const char* noCause : {"none", "two_causes", "unknown_harmonic"}) EXPECT_EQ(kinds.erase(noCause), 1u);
  EXPECT_THAT(diagnosableEffects(), IsSupersetOf(kinds));
}

TEST(CauseIds, OfTheRelationIsTheOneEffectThatIsThereOrNot) {
  for (const Effect& effect : effectCatalogue())
    EXPECT_EQ(effect.id == relationId, effect.response == Response::AllOrNothing) << effect.id;
}

}  // namespace
}  // namespace alidade
