#include "core/wording/series_words.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(Copies, AreCalledByTheirFilesOrByAllThatTellsThemApart) {
  EXPECT_EQ(copyReason("/here/b.alidade", "/here/a.alidade"),
            "holds the same readings as a.alidade: counted once");
  EXPECT_EQ(copySentence("/here/b.alidade", "/there/a.alidade"),
            "b.alidade holds the same readings as a.alidade: counted once.");
  EXPECT_EQ(copySentence("/here/a.alidade", "/there/a.alidade"),
            "/here/a.alidade holds the same readings as /there/a.alidade: counted once.");
  EXPECT_EQ(copyReason("b", "\xFF.alidade"), "holds the same readings as \\xff.alidade: counted once");
}

}  // namespace
}  // namespace alidade
