#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "core/adjustment/result/setup_findings.h"
#include "core/base/angle_text.h"
#include "core/diagnosis/diagnose.h"
#include "core/effects/cause_ids.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

namespace alidade {
namespace {

// A misread sighting of a pointing zero, of four in both faces before and after the readings.

/// A session of no effect with all zeros in full, Δd 0.3 mm.
Session sound(const char* protocol, VerticalCircle circle, std::uint64_t seed) {
  Truth truth = drawTruth(seed);
  truth.sightsZerosInFull = true;
  truth.intersection = 0.3;
  truth.verticalCircle = circle;
  if (circle == VerticalCircle::Elevation) truth.verticalZero = Angle();
  return *simulate(*protocolByName(protocol), truth, seed);
}

struct Misreading {
  std::size_t position = 0;
  int face = 1;
  bool isAfter = false;
  ReadingKind kind = ReadingKind::Horizontal;
  double arcseconds = 0;
};

void misread(Session& session, const Misreading& wrong) {
  PointingZero& zero = session.positions[wrong.position].zero;
  std::string* text = wrong.kind == ReadingKind::Horizontal ? &zero.horizontal : &zero.vertical;
  for (const ZeroSlot& slot : furtherZeros)
    if (slot.face == wrong.face && slot.isAfter == wrong.isAfter) {
      ZeroSighting& sighting = zero.*slot.sighting;
      text = wrong.kind == ReadingKind::Horizontal ? &sighting.horizontal : &sighting.vertical;
    }
  const double degrees = (*parseAngle(*text) + Angle::fromArcseconds(wrong.arcseconds)).degrees();
  *text = formatDms(Angle::fromDegrees(std::fmod(degrees + 360, 360)), 1);
}

// Every sighting and circle: the misread one is named, with its size within 4 σ of the difference of two
// sightings (2 √2″); Δd, measured, and its U are those of the session without the misreading, as three
// sightings of a zero are nearly as good as four.
TEST(MisreadZero, IsNamedAndTakesNoPart) {
  std::uint64_t seed = 0;
  for (const char* protocol : {"two-face", "full"})
    for (const VerticalCircle circle : {VerticalCircle::Zenith, VerticalCircle::Elevation})
      for (const int face : {1, 2})
        for (const bool isAfter : {false, true})
          for (const ReadingKind kind : {ReadingKind::Horizontal, ReadingKind::Vertical}) {
            ++seed;
            const double size = (seed % 3 == 0 ? 600.0 : 60.0) * (seed % 2 == 0 ? 1 : -1);
            const Misreading wrong{seed % 2, face, isAfter, kind, size};
            SCOPED_TRACE(testing::Message() << protocol << " seed " << seed << " face " << face << " after "
                                            << isAfter << " size " << size);
            Session session = sound(protocol, circle, seed);
            const auto clean = diagnose(*examine(session).measurement);
            misread(session, wrong);
            const auto diagnosis = diagnose(*examine(session).measurement);
            const auto cause = std::ranges::find(diagnosis->causes, grossErrorId, &Cause::effect);
            ASSERT_NE(cause, diagnosis->causes.end());
            ASSERT_EQ(cause->readings.size(), 1u);
            const ReadingDeviation& found = cause->readings.front();
            EXPECT_TRUE(found.isZero);
            EXPECT_EQ(found.position, wrong.position);
            EXPECT_EQ(found.face, face);
            EXPECT_EQ(found.isAfter, isAfter);
            EXPECT_EQ(found.kind, kind);
            EXPECT_NEAR(found.size, size, 4 * 2 * std::sqrt(2.0));
            EXPECT_EQ(diagnosis->causes.size(), clean->causes.size() + 1);
            const IntersectionEstimate &estimate = diagnosis->measured->estimate,
                                       &wanted = clean->measured->estimate;
            EXPECT_NEAR(estimate.value, wanted.value, 0.5 * wanted.expanded);
            EXPECT_NEAR(estimate.expanded, wanted.expanded, 0.3 * wanted.expanded);
          }
}

// A tripod knocked after the last row moves both faces of the zero sighted then, as if both were misread
// alike. They take no part, and Δd is that of the session without the knock.
TEST(MisreadZero, MayBeAKnockAfterTheReadings) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    Session session = sound("full", VerticalCircle::Zenith, seed);
    const IntersectionEstimate clean = diagnose(*examine(session).measurement)->measured->estimate;
    for (const int face : {1, 2}) misread(session, {0, face, true, ReadingKind::Horizontal, 60});
    const IntersectionEstimate knocked = diagnose(*examine(session).measurement)->measured->estimate;
    EXPECT_NEAR(knocked.value, clean.value, 0.5 * clean.expanded) << seed;
    EXPECT_NEAR(knocked.expanded, clean.expanded, 0.3 * clean.expanded) << seed;
  }
}

// The fit itself says so as well: the zero changed in one face only.
TEST(MisreadZero, IsNoMoveOfTheZero) {
  using setup_finding::ZeroMoved;
  for (const int face : {1, 2}) {
    Session session = sound("two-face", VerticalCircle::Zenith, 7);
    misread(session, {1, face, true, ReadingKind::Vertical, 60});
    const Measurement measurement = *examine(session).measurement;
    const ZeroMoved* moved = nullptr;
    const std::vector<FitFinding> findings = setupFindings(measurement, fitSession(measurement));
    for (const FitFinding& finding : findings)
      if (const auto* one = std::get_if<ZeroMoved>(&finding.what)) moved = one;
    ASSERT_TRUE(moved);
    EXPECT_TRUE(moved->isOfOneFace);
    // Face 2 counts the other way, so its misreading changes the zero as read in face 1 by −60″.
    EXPECT_NEAR(moved->vertical.arcseconds(), -60, 4 * 2 * 2.0) << face;
    EXPECT_NEAR(moved->sigmaVertical.arcseconds(), 2 * 2, 1e-9) << "of four sightings of 2″";
  }
}

}  // namespace
}  // namespace alidade
