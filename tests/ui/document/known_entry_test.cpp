#include "ui/document/known_entry.h"

#include <gtest/gtest.h>

namespace alidade::ui {
namespace {

TEST(KnownEntry, IsNamedAsExamineNamesIt) {
  const KnownRef ref{KnownOwner::Device, 12};
  EXPECT_EQ(placeOf(ref, "sigma").path(), "device.known[12].sigma");
  EXPECT_EQ(placeOf({KnownOwner::Instrument, 0}).path(), "instrument.known[0]");
  const auto known = knownAt(placeOf(ref, "sigma"));
  ASSERT_TRUE(known);
  EXPECT_EQ(known->ref, ref);
  EXPECT_EQ(known->member, "sigma");
  EXPECT_EQ(knownAt(placeOf(ref))->member, "");
  for (const char* other : {"", "model.effects", "device.known", "device.known[]", "device.known[x].sigma",
                            "instrument.known[99999999999999999999]", "instrument.known[1", "device.name"})
    EXPECT_FALSE(knownAt({.field = other})) << other;
}

TEST(KnownEntry, BelongsToTheDeviceWhereItIsOfTheGuideway) {
  EXPECT_EQ(ownerOf(*effectById("arc_ellipticity")), KnownOwner::Device);
  EXPECT_EQ(ownerOf(*effectById("slider_scale")), KnownOwner::Device);
  EXPECT_EQ(ownerOf(*effectById("collimation")), KnownOwner::Instrument);
  EXPECT_EQ(ownerOf(*effectById("vertical_drift")), KnownOwner::Instrument);
}

}  // namespace
}  // namespace alidade::ui
