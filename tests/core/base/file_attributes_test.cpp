#include "core/base/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/xattr.h>

#include <cstdint>
#include <optional>

#include "tests/support/temporary_folder.h"

namespace alidade::test {
namespace {

constexpr const char* accessList = "system.posix_acl_access";

std::optional<std::string> attribute(const std::string& path, const char* name) {
  char value[256];
  const ssize_t size = getxattr(path.c_str(), name, value, sizeof value);
  return size < 0 ? std::nullopt : std::optional(std::string(value, static_cast<std::size_t>(size)));
}

/// An access control list in the format of the system: a version, then tag, rights and id of each entry,
/// little-endian. The owner may read and write, user 1234 may read, the group of the file has no rights. With
/// the mask, the mode of the file appears as 0660.
std::string listForOneReader() {
  struct Entry {
    std::uint16_t tag, rights;
    std::uint32_t id;
  };
  constexpr std::uint32_t nobody = 0xFFFFFFFF, version = 2;
  constexpr Entry entries[] = {
      {0x01, 6, nobody}, {0x02, 4, 1234}, {0x04, 0, nobody}, {0x10, 6, nobody}, {0x20, 0, nobody}};
  std::string list(reinterpret_cast<const char*>(&version), sizeof version);
  list.append(reinterpret_cast<const char*>(entries), sizeof entries);
  return list;
}

TEST(FileAttributes, OutliveASave) {
  const TemporaryFolder folder;
  const std::string file = folder.file("s.alidade", "old"), list = listForOneReader();
  if (setxattr(file.c_str(), accessList, list.data(), list.size(), 0) != 0)
    GTEST_SKIP() << "no access lists on this disk";
  const bool hasOwn = setxattr(file.c_str(), "user.project", "arc", 3, 0) == 0;
  ASSERT_FALSE(writeFile(file, "new", {}));
  EXPECT_EQ(attribute(file, accessList), list);
  if (hasOwn) {
    EXPECT_EQ(attribute(file, "user.project"), "arc");
  }
  struct stat status = {};
  ASSERT_EQ(stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0660u);
}

/// The folder's default list applies only to new files.
TEST(FileAttributes, OfTheFolderDoNotOpenAFileThatIsThere) {
  const TemporaryFolder folder;
  const std::string file = folder.file("s.alidade", "old"), list = listForOneReader();
  ASSERT_EQ(chmod(file.c_str(), 0640), 0);
  if (setxattr(folder.path().c_str(), "system.posix_acl_default", list.data(), list.size(), 0) != 0)
    GTEST_SKIP() << "no access lists on this disk";
  ASSERT_FALSE(writeFile(file, "new", {}));
  EXPECT_FALSE(attribute(file, accessList));
  struct stat status = {};
  ASSERT_EQ(stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

}  // namespace
}  // namespace alidade::test
