#include "core/connection/geocom_message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using testing::ElementsAre;

TEST(GeoComMessage, WritesQuestions) {
  EXPECT_EQ(geoComLine(GeoComQuestion{.rpc = 0}), "%R1Q,0:");
  EXPECT_EQ(geoComLine(GeoComQuestion{.rpc = 2003, .transaction = 5, .parameters = {"1"}}), "%R1Q,2003,5:1");
}

TEST(GeoComMessage, ReadsAnswersWithAndWithoutChecksum) {
  for (const char* line : {"%R1P,0,3:0,\"TS16 A, 1\",7", "%R1P,0,3,1117:0,\"TS16 A, 1\",7"}) {
    const auto answer = geoComAnswer(line);
    ASSERT_TRUE(answer) << line;
    EXPECT_EQ(answer->transaction, 3);
    EXPECT_EQ(answer->returnCode, 0);
    EXPECT_THAT(answer->parameters, ElementsAre("TS16 A, 1", "7"));
    EXPECT_TRUE(answer->isSound);
  }
}

// The sums by polynomial division, bit by bit; the first is the check value of CRC catalogues.
TEST(GeoComMessage, ChecksItsChecksum) {
  EXPECT_EQ(geoComChecksum("123456789"), 0xBB3D);
  EXPECT_EQ(geoComChecksum(""), 0);
  EXPECT_TRUE(geoComAnswer("%R1P,0,1,34666:0")->isSound);
  EXPECT_TRUE(geoComAnswer("~noise%R1P,0,1,34666:0")->isSound);
  for (const char* line :
       {"%R1P,0,1,34667:0", "%R1P,0,2,34666:0", "%R1P,0,1,34666:1", "%R1P,0,1,34666:0,1", "%R1P,0,1,0:0"})
    EXPECT_FALSE(geoComAnswer(line)->isSound) << line;
}

TEST(GeoComMessage, KnowsWhichCodesAreVouchedFor) {
  for (const int code : {0, 1285}) EXPECT_TRUE(isGuaranteed(code)) << code;
  for (const int code : {1283, 1284, 1288, 1289, 1290}) EXPECT_FALSE(isGuaranteed(code)) << code;
}

TEST(GeoComMessage, PassesOverNoiseBeforeAnAnswerAndHalfAnAnswer) {
  EXPECT_TRUE(geoComAnswer("\x01\xff~%R1P,0,1:0"));
  const auto answer = geoComAnswer("%R1P,0,1:0,4.3%R1P,0,2:1293");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->transaction, 2);
  EXPECT_EQ(answer->returnCode, geocom::busy);
}

TEST(GeoComMessage, RefusesWhatIsNoAnswer) {
  for (const char* line : {"", "%R1P", "%R1P,0:0", "%R1P,0,1", "%R1P,0,1:", "%R1P,0,x:0", "%R1P,0,1:abc",
                           "%R1Q,0,1:", "%R1P,0,1,2,3:0", "%R1P,-1,1:0", "%R1P,0,99999999999:0"})
    EXPECT_FALSE(geoComAnswer(line)) << line;
}

TEST(GeoComMessage, KnowsWhichCodesComeWithAngles) {
  for (const int code : {0, 1283, 1284, 1285, 1288, 1289}) EXPECT_TRUE(hasAngles(code)) << code;
  for (const int code : {1, 5, 1290, 1293, 3077}) EXPECT_FALSE(hasAngles(code)) << code;
}

TEST(GeoComMessage, SaysEachCodeAsASentence) {
  for (const int code : {0, 1283, 1284, 1285, 1288, 1289, 1290, 1293, 3075, 3077, 3085, 4711}) {
    const std::string sentence = geoComSentence(code);
    EXPECT_TRUE(sentence.ends_with('.') || sentence.ends_with('?')) << sentence;
  }
  EXPECT_NE(geoComSentence(4711).find("4711"), std::string::npos);
}

}  // namespace
}  // namespace alidade
