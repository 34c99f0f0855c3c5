#include "core/session/readings_digest.h"

#include <gmock/gmock.h>

#include <functional>

#include "core/session/session_file.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using testing::ElementsAre;

std::string digestOf(const std::function<void(Session&)>& change = [](Session&) {}) {
  Session session = test::paperSession();
  session.measuredOn = "2026-01-02";
  change(session);
  return readingsDigest(session, *examine(session).measurement);
}

TEST(ReadingsDigest, IsThatOfACopyHoweverItWasSaved) {
  EXPECT_EQ(digestOf([](Session& session) {
              session.title = "copy";
              session.notes = "saved anew";
              session.acceptance.toleranceMm = "7";
              session.geometry.distanceMm = "2406";
            }),
            digestOf());
  EXPECT_EQ(digestOf([](Session& session) {
              Reading& row = session.positions[0].readings[0];
              ASSERT_EQ(row.horizontal, "341°52'24\"");
              row.horizontal = "341 52 24.0";
              row.round.clear();
            }),
            digestOf())
      << "the same angle, written otherwise";
}

TEST(ReadingsDigest, IsThatOfACopyTypedInAnotherUnit) {
  const auto withFirst = [](const std::string& horizontal, const std::string& vertical) {
    return digestOf([&](Session& session) {
      session.positions[0].readings[0].horizontal = horizontal;
      session.positions[0].readings[0].vertical = vertical;
    });
  };
  const std::string digest = withFirst("341°52'24\"", "83°50'34.05\"");
  EXPECT_EQ(withFirst("341.87333°", "83.842791667°"), digest);
  EXPECT_EQ(withFirst("379.859259259gon", "93.158657407gon"), digest);
  EXPECT_NE(withFirst("341°52'24\"", "83°50'34.2\""), digest);
}

TEST(ReadingsDigest, IsAnotherOfWhateverElseWasReadOrSighted) {
  const std::vector<std::function<void(Session&)>> changes = {
      [](Session& session) { session.positions[0].readings[3].vertical = "83°50'35\""; },
      [](Session& session) { session.positions[1].readings.pop_back(); },
      [](Session& session) { session.positions[1].zero.horizontal = "332°32'55\""; },
      [](Session& session) { session.positions[0].readings[2].slider = "12°"; },
      [](Session& session) { session.measuredOn = "2026-01-03"; },
      [](Session& session) { session.instrument.serial = "T-1"; },
      [](Session& session) { session.device.serial = "G-1"; },
      [](Session& session) { session.device.name = "another"; },
      [](Session& session) { std::swap(session.positions[0].axisDeg, session.positions[1].axisDeg); }};
  std::vector<std::string> digests{digestOf()};
  for (const auto& change : changes) digests.push_back(digestOf(change));
  const std::vector<std::size_t> firsts = firstsAlike(digests);
  for (std::size_t i = 0; i < firsts.size(); ++i) EXPECT_EQ(firsts[i], i);
}

TEST(ReadingsDigest, TheFirstOfThoseAlikeIsFound) {
  EXPECT_THAT(firstsAlike({"a", "b", "a", "", "b", "", "a"}), ElementsAre(0, 1, 0, 3, 1, 5, 0));
}

}  // namespace
}  // namespace alidade
