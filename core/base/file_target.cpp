#include "core/base/file_target.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <system_error>

#include "core/base/phrase.h"

namespace alidade {

namespace {

namespace fs = std::filesystem;

fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// The descriptor in a name such as /dev/stdout, /dev/fd/1 or /proc/self/fd/1; absent for other names.
/// Opening the name again would write the file from its start.
std::optional<int> ownDescriptor(const fs::path& path) {
  std::error_code error;
  const fs::path folder = fs::canonical(folderOf(path), error), own = fs::canonical("/proc/self/fd", error);
  const std::string name = path.filename().string();
  int number = 0;
  const auto [end, trouble] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool isNumber = trouble == std::errc() && end == name.data() + name.size();
  return !error && folder == own && isNumber ? std::optional(number) : std::nullopt;
}

/// Does the kernel refuse to follow the link, as for another user's link in a sticky folder writable by all
/// (`fs.protected_symlinks`)?
bool isForbiddenLink(const fs::path& link) {
  const int file = open(link.c_str(), O_PATH | O_CLOEXEC);
  if (file < 0) return errno == EACCES;
  close(file);
  return false;
}

/// The target at this path, which is not a link.
Result<FileTarget> existingTarget(const fs::path& path, const struct stat& status) {
  FileTarget target{path.string(), FileTarget::Kind::File, status.st_mode & mode_t{07777}, status.st_uid,
                    status.st_gid};
  if (S_ISDIR(status.st_mode)) return Problem{whyUnwritable(EISDIR)};
  if (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode)) {
    target.kind = FileTarget::Kind::Direct;
    return target;
  }
  if (!S_ISREG(status.st_mode))
    return Problem{Phrase::of("the name is used by something other than a file: choose another name")};
  if (faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
    return Problem{Phrase::of("the file is read-only: choose another name, or make it writable")};
  return target;
}

}  // namespace

std::string FileTarget::folder() const {
  return folderOf(path).string();
}

Result<FileTarget> fileTarget(const std::string& path) {
  constexpr int mostLinks = 40;
  fs::path place(path);
  if (place.empty()) return Problem{Phrase::of("no name is given: enter one")};
  if (!place.has_filename()) return Problem{whyUnwritable(EISDIR)};
  for (int link = 0; link < mostLinks; ++link) {
    if (const auto descriptor = ownDescriptor(place))
      return FileTarget{.path = place.string(), .kind = FileTarget::Kind::Direct, .descriptor = descriptor};
    struct stat status = {};
    if (lstat(place.c_str(), &status) != 0) {
      if (errno != ENOENT) return Problem{whyUnwritable(errno)};
      std::error_code error;
      if (!fs::is_directory(folderOf(place), error)) return Problem{whyUnwritable(ENOENT)};
      return FileTarget{.path = place.string()};
    }
    if (!S_ISLNK(status.st_mode)) return existingTarget(place, status);
    if (isForbiddenLink(place))
      return Problem{Phrase::of(
          "it is another user's link in a folder that everyone may write to: choose another name")};
    std::error_code error;
    const fs::path next = fs::read_symlink(place, error);
    if (error) return Problem{whyUnwritable(error.value())};
    place = folderOf(place) / next;
  }
  return Problem{whyUnwritable(ELOOP)};
}

std::string whyUnwritable(int error) {
  switch (error) {
    case ENOSPC:
      return Phrase::of("the disk is full: make room there or choose another folder");
    case EDQUOT:
      return Phrase::of("your share of the disk is used up: make room there or choose another folder");
    case EFBIG:
      return Phrase::of("the file exceeds the size limit of the disk: choose another folder");
    case EACCES:
    case EPERM:
      return Phrase::of("you may not write there: choose another folder");
    case EROFS:
      return Phrase::of("the disk can only be read: choose another folder");
    case ENOENT:
    case ENOTDIR:
      return Phrase::of("its folder does not exist: choose another folder");
    case EISDIR:
      return Phrase::of("a folder has this name: choose another name");
    case ENAMETOOLONG:
      return Phrase::of("its name is too long: choose a shorter one");
    case ELOOP:
      return Phrase::of("its links form a loop: choose another name");
    default:
      //: what the system says is wrong
      return Phrase::of("%1: choose another name or folder", std::generic_category().message(error));
  }
}

bool isSameFile(const std::string& a, const std::string& b) {
  struct stat one = {}, other = {};
  const bool isOne = stat(a.c_str(), &one) == 0, isOther = stat(b.c_str(), &other) == 0;
  if (isOne && isOther)
    return S_ISREG(one.st_mode) && one.st_dev == other.st_dev && one.st_ino == other.st_ino;
  if (isOne || isOther) return false;
  const auto target = fileTarget(a), otherTarget = fileTarget(b);
  if (!target || !otherTarget) return a == b;
  std::error_code error;
  return fs::path(target->path).filename() == fs::path(otherTarget->path).filename() &&
         fs::equivalent(target->folder(), otherTarget->folder(), error);
}

}  // namespace alidade
