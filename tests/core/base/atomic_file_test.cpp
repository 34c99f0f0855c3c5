#include "core/base/atomic_file.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <sstream>
#include <utility>

#include "core/base/file_bytes.h"
#include "tests/support/temporary_folder.h"

namespace alidade::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
namespace fs = std::filesystem;

class AtomicFile : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder.path() / name).string(); }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path()))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  /// Returns the sentence of the refusal. The old file must be complete and alone in its folder.
  std::string refusal(const FileCalls& calls) const {
    const std::string old = folder.file("old", "kept");
    const auto problem = writeFile(old, std::string(100000, 'x'), {}, calls);
    EXPECT_EQ(*readFile(old), "kept");
    EXPECT_THAT(names(), ElementsAre("old"));
    EXPECT_TRUE(problem);
    if (!problem) return {};
    EXPECT_THAT(problem->what, StartsWith(old + " cannot be written: "));
    return problem->what;
  }

  TemporaryFolder folder;
};

template <typename Call>
auto failing(int error, const Call&) {
  return [error](auto...) {
    errno = error;
    return -1;
  };
}

TEST_F(AtomicFile, WritesANewFileAndReplacesAnOldOne) {
  EXPECT_FALSE(writeFile(path("a"), "first", {}));
  EXPECT_EQ(*readFile(path("a")), "first");
  EXPECT_FALSE(writeFile(path("a"), "", {}));
  EXPECT_EQ(*readFile(path("a")), "");
  EXPECT_THAT(names(), ElementsAre("a"));
}

TEST_F(AtomicFile, WritesRelativeToTheWorkingFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  EXPECT_FALSE(writeFile("here", "x", {}));
  fs::current_path(before);
  EXPECT_EQ(*readFile(path("here")), "x");
}

// A new file has the usual permissions.
TEST_F(AtomicFile, KeepsThePermissionsOfTheOldFile) {
  const auto modeOf = [](const std::string& file) {
    struct stat status = {};
    EXPECT_EQ(stat(file.c_str(), &status), 0);
    return status.st_mode & 07777U;
  };
  ASSERT_FALSE(writeFile(path("new"), "x", {}));
  EXPECT_EQ(modeOf(path("new")), modeOf(folder.file("any", "x")));
  for (const unsigned mode : {0600U, 0640U, 0664U}) {
    ASSERT_EQ(chmod(path("new").c_str(), mode), 0);
    ASSERT_FALSE(writeFile(path("new"), "y", {}));
    EXPECT_EQ(modeOf(path("new")), mode);
  }
}

// Else the group of the writing program would get what the file's own group may do. Only root can make a file
// of a group that it is not in.
TEST_F(AtomicFile, GivesAGroupThatDidNotHaveTheFileTheRightsOfAllOthers) {
  FileCalls calls;
  calls.changeGroup = failing(EPERM, calls.changeGroup);
  const auto modeAfter = [&](unsigned mode, gid_t group) {
    const std::string file = folder.file("shared", "x");
    EXPECT_EQ(chown(file.c_str(), static_cast<uid_t>(-1), group), 0);
    EXPECT_EQ(chmod(file.c_str(), mode), 0);
    EXPECT_FALSE(writeFile(file, "y", {}, calls));
    struct stat status = {};
    EXPECT_EQ(stat(file.c_str(), &status), 0);
    return status.st_mode & 07777U;
  };
  EXPECT_EQ(modeAfter(0660, getegid()), 0660U) << "it had the file";
  if (geteuid() != 0) GTEST_SKIP() << "needs root";
  const gid_t other = getegid() + 1;
  for (const auto& [before, after] :
       {std::pair(0660U, 0600U), {0640U, 0600U}, {0664U, 0644U}, {0644U, 0644U}})
    EXPECT_EQ(modeAfter(before, other), after);
}

TEST_F(AtomicFile, FollowsLinksAndLeavesThem) {
  fs::create_directory(folder.path() / "real");
  fs::create_symlink("real/file", path("near"));
  fs::create_symlink(path("near"), path("far"));
  EXPECT_FALSE(writeFile(path("far"), "first", {}));
  EXPECT_FALSE(writeFile(path("far"), "second", {}));
  EXPECT_EQ(*readFile(path("real/file")), "second");
  EXPECT_TRUE(fs::is_symlink(path("far")) && fs::is_symlink(path("near")));
  fs::create_symlink(path("round"), path("about"));
  fs::create_symlink(path("about"), path("round"));
  EXPECT_THAT(writeFile(path("round"), "x", {})->what, HasSubstr("form a loop"));
}

// Each step that may fail does so in turn, as on a full or failing disk.
TEST_F(AtomicFile, LeavesTheOldFileWhereAStepFails) {
  FileCalls calls;
  calls.open = failing(EACCES, calls.open);
  EXPECT_THAT(refusal(calls), HasSubstr("you may not write there: choose another folder"));
  calls.open = failing(EROFS, calls.open);
  EXPECT_THAT(refusal(calls), HasSubstr("can only be read"));
  calls = {};
  calls.write = failing(ENOSPC, calls.write);
  EXPECT_THAT(refusal(calls), HasSubstr("the disk is full: make room"));
  calls.write = [](auto...) { return ssize_t{0}; };
  EXPECT_THAT(refusal(calls), HasSubstr("choose another"));
  calls = {};
  calls.sync = failing(EIO, calls.sync);
  EXPECT_THAT(refusal(calls), HasSubstr("Input/output error"));
  calls = {};
  calls.close = [](int file) {
    ::close(file);
    errno = EDQUOT;
    return -1;
  };
  EXPECT_THAT(refusal(calls), HasSubstr("share of the disk"));
  calls = {};
  calls.rename = failing(EIO, calls.rename);
  EXPECT_THAT(refusal(calls), HasSubstr("Input/output error"));
}

TEST_F(AtomicFile, NoticesADiskThatFillsUpHalfWay) {
  FileCalls calls;
  std::size_t room = 70000;
  calls.write = [&room](int file, const void* bytes, std::size_t count) {
    const std::size_t part = std::min({count, room, std::size_t{4096}});
    room -= part;
    if (part > 0) return ::write(file, bytes, part);
    errno = ENOSPC;
    return ssize_t{-1};
  };
  EXPECT_THAT(refusal(calls), HasSubstr("the disk is full"));
  room = 200000;
  EXPECT_FALSE(writeFile(path("old"), std::string(100000, 'x'), {}, calls)) << "written in many parts";
  EXPECT_EQ(readFile(path("old"))->size(), 100000u);
}

// The kernel's own limit, without a replaced call.
TEST_F(AtomicFile, NoticesTheLimitOfTheSystem) {
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small = {.rlim_cur = 5000, .rlim_max = limit.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string sentence = refusal({});
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  std::signal(SIGXFSZ, before);
  EXPECT_THAT(sentence, HasSubstr("exceeds the size limit"));
}

TEST_F(AtomicFile, SynchronisesTheFileBeforeItTakesItsPlaceAndThenTheFolder) {
  std::vector<std::string> steps;
  FileCalls calls;
  calls.sync = [&](int file) {
    struct stat status = {};
    fstat(file, &status);
    steps.emplace_back(S_ISDIR(status.st_mode) ? "sync folder" : "sync file");
    return ::fsync(file);
  };
  calls.rename = [&](const char* from, const char* to) {
    steps.emplace_back("rename");
    return std::rename(from, to);
  };
  EXPECT_FALSE(writeFile(path("a"), "x", {}, calls));
  EXPECT_THAT(steps, ElementsAre("sync file", "rename", "sync folder"));
  // Disks without synchronisation are still written to.
  calls.sync = failing(EINVAL, calls.sync);
  EXPECT_FALSE(writeFile(path("a"), "x", {}, calls));
}

TEST_F(AtomicFile, NamesWhatStandsInTheWay) {
  EXPECT_THAT(writeFile(path("no/file"), "x", {})->what, HasSubstr("its folder does not exist"));
  EXPECT_THAT(writeFile(folder.file("file", "") + "/below", "x", {})->what,
              HasSubstr("its folder does not exist"));
  fs::create_directory(folder.path() / "taken");
  EXPECT_THAT(writeFile(path("taken"), "x", {})->what, HasSubstr("a folder has this name"));
  EXPECT_THAT(writeFile(path("taken") + "/", "x", {})->what, HasSubstr("a folder has this name"));
  EXPECT_THAT(writeFile(path(std::string(300, 'n')), "x", {})->what, HasSubstr("too long"));
  EXPECT_THAT(writeFile("", "x", {})->what, HasSubstr("no name"));
}

TEST_F(AtomicFile, SaysThatTheFolderVanishedMeanwhile) {
  FileCalls calls;
  const std::string gone = path("gone");
  fs::create_directory(gone);
  calls.rename = [&](const char* from, const char* to) {
    fs::remove_all(gone);
    return std::rename(from, to);
  };
  EXPECT_THAT(writeFile(gone + "/file", "x", {}, calls)->what, HasSubstr("its folder does not exist"));
}

TEST_F(AtomicFile, NeverReplacesWhatItWasMadeFrom) {
  const std::string input = folder.file("input", "kept");
  fs::create_symlink(input, path("link"));
  fs::create_hard_link(input, path("hard"));
  for (const std::string& name : {input, path("./input"), path("link"), path("hard")}) {
    const auto problem = writeFile(name, "lost", {"elsewhere", input});
    ASSERT_TRUE(problem) << name;
    EXPECT_THAT(problem->what, HasSubstr("the file being read")) << name;
    EXPECT_TRUE(writeFile(input, "lost", {name})) << name;
  }
  EXPECT_EQ(*readFile(input), "kept");
  EXPECT_FALSE(writeFile(path("other"), "x", {input}));
}

TEST_F(AtomicFile, WritesSeveralOnlyWhenAllCanBe) {
  const std::string first = folder.file("first", "kept");
  EXPECT_THAT(writeFiles({{first, "a"}, {path("no/second"), "b"}}, {})->what, HasSubstr("no/second"));
  EXPECT_THAT(writeFiles({{first, "a"}, {"/dev/full", "b"}}, {})->what, HasSubstr("the disk is full"));
  int writes = 0;
  FileCalls calls;
  calls.write = [&](int file, const void* bytes, std::size_t count) {
    if (++writes < 2) return ::write(file, bytes, count);
    errno = ENOSPC;
    return ssize_t{-1};
  };
  EXPECT_TRUE(writeFiles({{first, "a"}, {path("second"), "b"}}, {}, calls));
  EXPECT_EQ(*readFile(first), "kept");
  EXPECT_THAT(names(), ElementsAre("first"));
  EXPECT_FALSE(writeFiles({{first, "a"}, {path("second"), "b"}, {"/dev/null", "c"}}, {}));
  EXPECT_EQ(*readFile(first) + *readFile(path("second")), "ab");
}

// A device must not be replaced; it would be lost. A report and its signature are either both new or both
// old.
TEST_F(AtomicFile, PutsBackWhatTookItsPlaceBeforeAnotherFailed) {
  for (const bool isOld : {true, false})
    for (const int failingAt : {1, 2, 3}) {
      SCOPED_TRACE(failingAt);
      for (const char* name : {"a", "b", "c"}) {
        fs::remove(path(name));
        if (isOld) folder.file(name, "old");
      }
      FileCalls calls;
      int count = 0;
      calls.rename = [&](const char* from, const char* to) {
        if (++count != failingAt) return std::rename(from, to);
        errno = EIO;
        return -1;
      };
      const auto problem =
          writeFiles({{path("a"), "new"}, {path("b"), "new"}, {path("c"), "new"}}, {}, calls);
      ASSERT_TRUE(problem);
      EXPECT_THAT(problem->what, ::testing::Not(HasSubstr("already")));
      if (isOld) {
        for (const char* name : {"a", "b", "c"}) EXPECT_EQ(*readFile(path(name)), "old") << name;
      }
      EXPECT_EQ(names().size(), isOld ? 3U : 0U);
    }
}

TEST_F(AtomicFile, SaysWhatStandsWhereItCannotBePutBack) {
  folder.file("a", "old");
  folder.file("b", "old");
  FileCalls calls;
  int count = 0;
  calls.rename = [&](const char* from, const char* to) {
    if (++count == 1) return std::rename(from, to);
    errno = EIO;
    return -1;
  };
  const auto problem = writeFiles({{path("a"), "new"}, {path("b"), "new"}}, {}, calls);
  ASSERT_TRUE(problem);
  EXPECT_THAT(problem->what, StartsWith(path("b") + " cannot be written: "));
  EXPECT_THAT(problem->what, HasSubstr(path("a") + " was already replaced, its previous content is in "));
  ASSERT_EQ(names().size(), 3U);
  EXPECT_EQ(*readFile(path(names().front())), "old") << "by its other name";
  EXPECT_THAT(problem->what, HasSubstr(names().front()));
}

// The new bytes of both files are there, though they may not survive a power cut.
TEST_F(AtomicFile, LeavesNoneBehindWhereTheFolderCannotBeSynchronised) {
  FileCalls calls;
  calls.sync = [](int file) {
    struct stat status = {};
    if (fstat(file, &status) != 0 || !S_ISDIR(status.st_mode)) return 0;
    errno = EIO;
    return -1;
  };
  folder.file("a", "old");
  EXPECT_TRUE(writeFiles({{path("a"), "new"}, {path("b"), "new"}}, {}, calls));
  EXPECT_EQ(*readFile(path("a")), "new");
  EXPECT_EQ(*readFile(path("b")), "new");
  EXPECT_THAT(names(), ElementsAre("a", "b"));
}

TEST_F(AtomicFile, WritesToDevicesAndPipesDirectly) {
  EXPECT_FALSE(writeFile("/dev/null", "x", {"/dev/null"}));
  fs::create_symlink("/dev/full", path("full"));
  EXPECT_THAT(writeFile(path("full"), "x", {})->what, HasSubstr("the disk is full"));
  EXPECT_TRUE(fs::is_character_file("/dev/null") && fs::is_character_file("/dev/full"));
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  EXPECT_FALSE(writeFile(path("pipe"), "through", {}));
  char bytes[16] = {};
  EXPECT_EQ(read(reader, bytes, sizeof bytes), 7);
  EXPECT_STREQ(bytes, "through");
  close(reader);
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

// Reopening the file by its name would overwrite the earlier output of the program.
TEST_F(AtomicFile, WritesOnToAnOpenFileOfTheProgram) {
  const int file = open(path("log").c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(write(file, "one ", 4), 4);
  EXPECT_FALSE(writeFile("/dev/fd/" + std::to_string(file), "two ", {}));
  EXPECT_FALSE(writeFile("/proc/self/fd/" + std::to_string(file), "three", {}));
  close(file);
  EXPECT_EQ(*readFile(path("log")), "one two three");
}

}  // namespace
}  // namespace alidade::test
