#include "core/session/own_effect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/session/measurement.h"
#include "core/session/session_file.h"

namespace alidade {
namespace {

using testing::HasSubstr;

OwnEffect dent() {
  return {.id = "dent",
          .name = "dent at 83°",
          .description = "the guideway was hit",
          .device = "G-7",
          .formula = "radial = A*bump(s, 83°, 4°)",
          .parameters = {{"A", "0.2", "mm"}},
          .remedy = "grind it off",
          .from = "found in “June”"};
}

/// A session that takes no readings but can be examined.
Session session() {
  Session blank = blankSession();
  blank.geometry.distanceMm = "2405";
  blank.geometry.radiusMm = "400";
  blank.device.serial = "G-7";
  blank.instrument.serial = "T-1";
  return blank;
}

TEST(OwnEffectFile, IsReadAsItWasWritten) {
  const std::string text = writeOwnEffect(dent());
  const Result<OwnEffect> read = readOwnEffect(text);
  ASSERT_TRUE(read) << read.problem().text();
  EXPECT_EQ(*read, dent());
  EXPECT_EQ(writeOwnEffect(*read), text);
}

TEST(OwnEffectFile, SaysWhereItIsWrong) {
  const auto problemOf = [](const OwnEffect& effect) {
    const Result<OwnEffect> read = readOwnEffect(writeOwnEffect(effect));
    return read ? std::string() : read.problem().text();
  };
  OwnEffect effect = dent();
  effect.formula = "radial = A*foo(s)";
  EXPECT_THAT(problemOf(effect), HasSubstr("formula: Line 1, column 12: “foo”"));
  effect = dent();
  effect.parameters[0].plausible = "-1";
  EXPECT_THAT(problemOf(effect), HasSubstr("parameters[0].plausible"));
  effect = dent();
  effect.parameters[0].unit = "arcsec";
  EXPECT_THAT(problemOf(effect), HasSubstr("parameters[0].unit"));
  effect = dent();
  effect.parameters.clear();
  EXPECT_THAT(problemOf(effect), HasSubstr("lack the amplitude “A”"));
  effect = dent();
  effect.parameters.push_back({"B", "1", "mm"});
  EXPECT_THAT(problemOf(effect), HasSubstr("parameters[1].name"));
  effect = dent();
  effect.id = "../etc";
  EXPECT_THAT(problemOf(effect), HasSubstr("id: must be"));
  EXPECT_THAT(readOwnEffect("{\"format\": \"alidade-session\", \"version\": 1}").problem().text(),
              HasSubstr("format"));
}

TEST(OwnEffects, AreKeptByTheSession) {
  Session own = session();
  EXPECT_THAT(writeSession(own), testing::Not(HasSubstr("own_effects"))) << "nothing of what is not there";
  ASSERT_TRUE(takeOwnEffect(own, dent()));
  const Result<Session> read = readSession(writeSession(own));
  ASSERT_TRUE(read) << read.problem().text();
  EXPECT_EQ(*read, own);
  const Examined examined = examine(*read);
  ASSERT_TRUE(examined.measurement && examined.measurement->own);
  const OwnEntry& entry = examined.measurement->own->entries().front();
  EXPECT_EQ(entry.id, "own:dent");
  ASSERT_EQ(entry.effect.parameters.size(), 1u);
  EXPECT_EQ(entry.effect.parameters[0].plausible, 0.2);
  EXPECT_EQ(entry.effect.parameters[0].unit, "mm");
  EXPECT_TRUE(isOfGuideway(entry.effect.parameters[0].term));
}

TEST(OwnEffects, AreOfTheirOwnerOnly) {
  Session own = session();
  OwnEffect effect = dent();
  effect.device = "G-8";
  EXPECT_FALSE(takeOwnEffect(own, effect));
  EXPECT_TRUE(own.ownEffects.empty());
  effect.device.clear();
  effect.instrument = "T-1";
  EXPECT_TRUE(takeOwnEffect(own, effect));
  effect.instrument.clear();
  effect.name = "anybody's";
  EXPECT_TRUE(takeOwnEffect(own, effect)) << "without an owner";
  ASSERT_EQ(own.ownEffects.size(), 1u) << "in place of the one with the same id";
  EXPECT_EQ(own.ownEffects[0].name, "anybody's");
  Session unnamed = session();
  unnamed.device.serial.clear();
  EXPECT_FALSE(takeOwnEffect(unnamed, dent())) << "a session that does not say which device it is of";
}

TEST(OwnEffects, ThatCannotBeUsedAreToldAndLeftOut) {
  Session own = session();
  OwnEffect wide{.id = "wide", .formula = "x = A+B+C+D", .parameters = {}};
  for (const char* name : {"A", "B", "C", "D"}) wide.parameters.push_back({name, "1", ""});
  OwnEffect again = wide, wrong = dent();
  again.id = "again";
  wrong.id = "wrong";
  wrong.formula = "radial = A*";
  own.ownEffects = {wide, again, wrong, dent(), dent()};
  const Examined examined = examine(own);
  ASSERT_TRUE(examined.measurement && examined.measurement->own);
  EXPECT_EQ(examined.measurement->own->entries().size(), 2u);
  std::vector<std::string> fields;  // the rest is that nothing was read
  for (const Problem& problem : examined.problems)
    if (problem.where.field.starts_with("own_effects")) fields.push_back(problem.where.field);
  EXPECT_THAT(fields,
              testing::ElementsAre("own_effects[1].formula", "own_effects[2].formula", "own_effects[4].id"));
}

TEST(OwnEffects, OfStrangersAreBounded) {
  Session own = session();
  own.ownEffects.assign(100'000, dent());
  const Examined examined = examine(own);
  ASSERT_TRUE(examined.measurement && examined.measurement->own);
  EXPECT_EQ(examined.measurement->own->entries().size(), 1u);
  const auto isLast = [](const Problem& problem) { return problem.where.field == "own_effects[20].id"; };
  EXPECT_EQ(std::ranges::count_if(examined.problems, isLast), 1) << "the rest is not even read";
}

}  // namespace
}  // namespace alidade
