#include "core/base/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <ctime>

#include "tests/support/temporary_folder.h"

namespace alidade::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* gone = "999999999";  // more than any process has

void age(const std::string& path, time_t seconds) {
  const timespec then{.tv_sec = time(nullptr) - seconds, .tv_nsec = 0};
  const timespec times[] = {then, then};
  ASSERT_EQ(utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
}

TEST(StaleFiles, OfKilledProcessesGoWithTheNextWrite) {
  const TemporaryFolder folder;
  const std::string left = folder.file(std::string(".alidade-") + gone + "-1.tmp", "half");
  age(left, 7200);
  ASSERT_FALSE(writeFile((folder.path() / "s.alidade").string(), "whole", {}));
  EXPECT_FALSE(fs::exists(left));
}

TEST(StaleFiles, AreOnlyOurOwnOldOnesOfNobody) {
  const TemporaryFolder folder;
  const std::string fresh = folder.file(std::string(".alidade-") + gone + "-2.tmp", "x");
  const std::string living = folder.file(".alidade-" + std::to_string(getpid()) + "-999.tmp", "x");
  const std::string kept = folder.file(std::string(".alidade-") + gone + "-3.old", "x");
  const std::string names[] = {"a.alidade-9-1.tmp", ".alidade-9.tmp",   ".alidade-9-1.tmp.alidade",
                               ".alidade--9-1.tmp", ".alidade-x-1.tmp", ".alidade-9-1x.tmp"};
  std::vector<std::string> others{living, kept};
  for (const std::string& name : names) others.push_back(folder.file(name, "x"));
  for (const std::string& other : others) age(other, 7200);
  const fs::path inside = folder.path() / (std::string(".alidade-") + gone + "-4.tmp");
  fs::create_directory(inside);
  clearStaleFiles(folder.path().string());
  others.push_back(fresh);
  others.push_back(inside.string());
  for (const std::string& other : others) EXPECT_TRUE(fs::exists(other)) << other;
}

}  // namespace
}  // namespace alidade::test
