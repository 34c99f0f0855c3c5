#include "ui/document/session_files.h"

#include <gtest/gtest.h>

namespace alidade::ui {
namespace {

// The undo stack as a list of events; indices as in QUndoStack.

TEST(SessionFiles, KnowWhereTheSessionIsAsInItsFile) {
  SessionFiles files;
  EXPECT_FALSE(files.isModified(0));
  files.dropFrom(0);
  EXPECT_TRUE(files.isModified(1));
  files.setSaved(1, QStringLiteral("a"));
  EXPECT_FALSE(files.isModified(1));
  EXPECT_TRUE(files.isModified(0));
  files.dropFrom(0);
  EXPECT_TRUE(files.isModified(1)) << "another command is there now";
  files.restart(QStringLiteral("b"));
  EXPECT_FALSE(files.isModified(0));
  EXPECT_EQ(files.path(0), QStringLiteral("b"));
}

TEST(SessionFiles, TellWhatUndoAndRedoLeadTo) {
  SessionFiles files;
  files.restart(QStringLiteral("a"));
  files.dropFrom(0);
  files.beginAnother(0);
  files.setSaved(1, QStringLiteral("b"));
  files.dropFrom(1);
  files.beginAnother(1);
  files.setSaved(2, QStringLiteral("c"));
  for (int index = 0; index < 3; ++index) {
    EXPECT_FALSE(files.isModified(index)) << index;
    EXPECT_EQ(files.path(index), QString(QLatin1Char("abc"[index])));
    EXPECT_FALSE(files.unsavedAhead(index, 3 - 1)) << index;
    EXPECT_FALSE(files.unsavedBehind(index, 3 - 1)) << index;
  }
  files.dropFrom(2);
  EXPECT_EQ(files.unsavedAhead(0, 3), QStringLiteral("c"));
  EXPECT_EQ(files.unsavedAhead(1, 3), QStringLiteral("c"));
  EXPECT_EQ(files.unsavedAhead(2, 3), std::nullopt) << "it is the one at work";
  files.dropFrom(1);
  EXPECT_EQ(files.unsavedAhead(0, 2), QStringLiteral("b")) << "c is dropped, b is edited";
}

TEST(SessionFiles, TellOfASessionBehindThatWasSavedInAnEarlierState) {
  SessionFiles files;
  files.restart(QStringLiteral("a"));
  files.dropFrom(0);
  files.setSaved(1, QStringLiteral("a"));
  files.dropFrom(1);
  files.beginAnother(1);
  files.setSaved(2, QStringLiteral("b"));
  EXPECT_EQ(files.unsavedBehind(2, 2), std::nullopt);
  files.setSaved(0, QStringLiteral("a"));
  EXPECT_EQ(files.unsavedBehind(2, 2), QStringLiteral("a"));
}

TEST(SessionFiles, DoNotTellOfWhatTheUserHasGivenUp) {
  SessionFiles files;
  files.restart(QStringLiteral("a"));
  files.dropFrom(0);
  files.dropFrom(1);
  files.beginAnother(1);
  EXPECT_EQ(files.unsavedBehind(2, 2), std::nullopt) << "left as it was, knowingly";
  EXPECT_TRUE(files.isModified(1));
  EXPECT_EQ(files.unsavedAhead(1, 2), QString()) << "the import is in no file";
}

TEST(SessionFiles, GiveEachSessionItsOwnNumber) {
  SessionFiles files;
  const int first = files.session(0);
  files.dropFrom(0);
  files.beginAnother(0);
  const int second = files.session(1);
  EXPECT_NE(first, second);
  EXPECT_EQ(files.session(0), first) << "undo leads back to it";
  files.restart({});
  EXPECT_NE(files.session(0), first);
  EXPECT_NE(files.session(0), second);
}

}  // namespace
}  // namespace alidade::ui
