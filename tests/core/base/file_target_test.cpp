#include "core/base/file_target.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace alidade::test {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

TEST(FileTarget, TellsWhatStandsThere) {
  const TemporaryFolder folder;
  const std::string file = folder.file("file", "x"), link = (folder.path() / "link").string();
  ASSERT_EQ(chmod(file.c_str(), 0640), 0);
  fs::create_symlink("file", link);
  for (const std::string& name : {file, link}) {
    const Result<FileTarget> target = fileTarget(name);
    ASSERT_TRUE(target);
    EXPECT_EQ(target->kind, FileTarget::Kind::File);
    EXPECT_EQ(target->path, file);
    EXPECT_EQ(target->folder(), folder.path());
    EXPECT_EQ(target->mode, 0640u);
  }
  EXPECT_EQ(fileTarget((folder.path() / "new").string())->kind, FileTarget::Kind::New);
  EXPECT_EQ(fileTarget("new")->folder(), ".");
  EXPECT_EQ(fileTarget("/dev/null")->kind, FileTarget::Kind::Direct);
  EXPECT_EQ(fileTarget("/dev/stdout")->descriptor, 1);
}

// A kernel that protects links refuses another user's link in such a folder for any reader.
TEST(FileTarget, FollowsNoLinkOfAnotherInAFolderThatAllMayWrite) {
  std::ifstream isProtected("/proc/sys/fs/protected_symlinks");
  const TemporaryFolder folder;
  const std::string file = folder.file("file", "x"), link = (folder.path() / "link").string();
  ASSERT_EQ(chmod(folder.path().c_str(), 01777), 0);
  fs::create_symlink(file, link);
  constexpr uid_t another = 12345;
  if (isProtected.get() != '1' || lchown(link.c_str(), another, another) != 0)
    GTEST_SKIP() << "links are not protected here, or only root can make one of another user";
  EXPECT_EQ(open(link.c_str(), O_RDONLY | O_CLOEXEC), -1) << "the kernel's own answer";
  const Result<FileTarget> target = fileTarget(link);
  ASSERT_FALSE(target);
  EXPECT_THAT(target.problem().what, HasSubstr("another user"));
}

// Users who may write everywhere are not stopped by a file's permissions.
TEST(FileTarget, RefusesAReadOnlyFile) {
  const TemporaryFolder folder;
  const std::string file = folder.file("file", "x");
  ASSERT_EQ(chmod(file.c_str(), 0440), 0);
  const Result<FileTarget> target = fileTarget(file);
  const bool mayWrite = access(file.c_str(), W_OK) == 0;
  EXPECT_THAT(target ? "" : target.problem().what, HasSubstr(mayWrite ? "" : "the file is read-only"));
  EXPECT_EQ(bool(target), mayWrite);
}

TEST(FileTarget, KnowsOneFileByAllItsNames) {
  const TemporaryFolder folder;
  const std::string file = folder.file("file", "x"), other = folder.file("other", "x");
  const auto in = [&](const std::string& name) { return (folder.path() / name).string(); };
  fs::create_symlink("file", in("link"));
  fs::create_hard_link(file, in("hard"));
  fs::create_symlink("missing", in("dangling"));
  for (const char* name : {"file", "./file", "link", "hard"}) EXPECT_TRUE(isSameFile(file, in(name))) << name;
  EXPECT_FALSE(isSameFile(file, other));
  EXPECT_FALSE(isSameFile(file, in("missing")));
  EXPECT_TRUE(isSameFile(in("missing"), in("./missing")));
  EXPECT_TRUE(isSameFile(in("missing"), in("dangling")));
  EXPECT_FALSE(isSameFile(in("missing"), in("absent")));
  EXPECT_FALSE(isSameFile("/dev/null", "/dev/null")) << "no file to be lost";
}

TEST(FileTarget, HasOneSentenceForEachTrouble) {
  for (const int error : {ENOSPC, EDQUOT, EFBIG, EACCES, EROFS, ENOENT, EISDIR, ENAMETOOLONG, ELOOP, EIO})
    EXPECT_THAT(whyUnwritable(error), HasSubstr(": ")) << error;
}

}  // namespace
}  // namespace alidade::test
