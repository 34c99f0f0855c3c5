#include "core/connection/line_assembler.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

using Texts = std::vector<std::string>;

TEST(LineAssembler, PartsLinesByEveryKindOfEndWhereverTheBytesAreSplit) {
  const std::string bytes = "one\r\ntwo\rthree\n\r\n\nfour\r\n";
  for (std::size_t split = 0; split <= bytes.size(); ++split) {
    LineAssembler assembler;
    Texts lines, remarks;
    assembler.take(bytes.substr(0, split), 0, lines, remarks);
    assembler.take(bytes.substr(split), 1, lines, remarks);
    EXPECT_EQ(lines, (Texts{"one", "two", "three", "four"})) << "split at " << split;
    EXPECT_EQ(remarks, Texts());
    EXPECT_FALSE(assembler.wakeAt());
  }
}

TEST(LineAssembler, DropsHalfALineWhenItsRestDoesNotCome) {
  LineAssembler assembler(2000);
  Texts lines, remarks;
  assembler.take("%R1P,0,3:0,4.3", 100, lines, remarks);
  EXPECT_EQ(assembler.wakeAt(), 2100);
  assembler.tick(2099, remarks);
  EXPECT_EQ(remarks, Texts());
  assembler.tick(2100, remarks);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("%R1P,0,3:0,4.3"), std::string::npos);
  assembler.take("whole\r\n", 3000, lines, remarks);
  EXPECT_EQ(lines, Texts{"whole"});
}

TEST(LineAssembler, DropsALateRestEvenIfNobodyTicked) {
  LineAssembler assembler(2000);
  Texts lines, remarks;
  assembler.take("half", 0, lines, remarks);
  assembler.take("other\r\n", 5000, lines, remarks);
  EXPECT_EQ(lines, Texts{"other"});
  EXPECT_EQ(remarks.size(), 1U);
}

TEST(LineAssembler, NeverGrowsWithALineWithoutAnEnd) {
  LineAssembler assembler;
  Texts lines, remarks;
  for (int i = 0; i < 10000; ++i) {
    assembler.take(std::string(700, 'x'), i, lines, remarks);
    ASSERT_LE(assembler.pending(), LineAssembler::longest);
  }
  EXPECT_EQ(lines, Texts());
  EXPECT_EQ(remarks.size(), 1U) << "one sentence for one line";
  assembler.take("\r\ngood\r\n", 10000, lines, remarks);
  EXPECT_EQ(lines, Texts{"good"});
}

TEST(LineAssembler, ShowsWhatCannotBeSeen) {
  EXPECT_EQ(shownLine("a\r\n\x1b[2J\xff~"), "a<CR><LF><1B>[2J<FF>~");
}

}  // namespace
}  // namespace alidade
