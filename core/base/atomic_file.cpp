#include "core/base/atomic_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <list>
#include <utility>

#include "core/base/file_target.h"
#include "core/base/phrase.h"

namespace alidade {

namespace {

constexpr int mostTries = 100;

/// Writes one file, directly or through a temporary file that replaces the target. A step that returns an int
/// returns the system's error number, 0 on success.
class Passage {
 public:
  Passage(const FileContent& content, FileTarget target, const FileCalls& calls)
      : m_content(content), m_target(std::move(target)), m_calls(calls) {}
  Passage(const Passage&) = delete;
  Passage& operator=(const Passage&) = delete;
  ~Passage() {
    for (const std::string& name : {m_temporary, m_kept})
      if (!name.empty()) unlink(name.c_str());
  }

  const FileContent& content() const { return m_content; }
  std::string folder() const { return m_target.folder(); }
  bool isDirect() const { return m_target.kind == FileTarget::Kind::Direct; }
  int writeDirectly();
  int writeTemporary();
  void keepOld();
  int takePlace();
  std::string putBack();
  int syncFolder();

 private:
  std::string freshName(const char* suffix) const;
  int openTemporary(int& file);
  int writeAll(int file) const;
  int sync(int file) const;
  int close(int file, int error) const;

  FileContent m_content;
  FileTarget m_target;
  const FileCalls& m_calls;
  std::string m_temporary;  ///< path of the temporary file; empty: none
  std::string m_kept;       ///< hard link to the replaced file; empty: none
  bool m_hasPlace = false;
};

int Passage::writeDirectly() {
  const int file = m_target.descriptor ? dup(*m_target.descriptor)
                                       : m_calls.open(m_target.path.c_str(), O_WRONLY | O_CLOEXEC, 0);
  return file < 0 ? errno : close(file, writeAll(file));
}

int Passage::writeTemporary() {
  int file = -1;
  if (const int error = openTemporary(file)) return error;
  const int error = writeAll(file);
  if (error == 0 && m_target.kind == FileTarget::Kind::File) {
    // A refused step is not an error. Without the old file's access list, the group gets no rights. A group
    // that did not have the old file gets only the rights of all others.
    struct stat now = {};
    const bool isGroupKept = m_calls.changeGroup(file, m_target.group) == 0 ||
                             (fstat(file, &now) == 0 && now.st_gid == m_target.group);
    const mode_t withoutGroup = m_target.mode & ~mode_t{S_IRWXG};
    [[maybe_unused]] const int ofMode = fchmod(file, withoutGroup);
    if (copyFileAttributes(m_target.path, file)) {
      const mode_t mode = isGroupKept ? m_target.mode : withoutGroup | ((m_target.mode & S_IRWXO) << 3U);
      [[maybe_unused]] const int ofGroup = fchmod(file, mode);
    }
  }
  return close(file, error == 0 ? sync(file) : error);
}

/// Returns a name in the target's folder, so that renaming stays on one disk.
std::string Passage::freshName(const char* suffix) const {
  static std::atomic<unsigned> count = 0;
  return m_target.folder() + "/.alidade-" + std::to_string(getpid()) + "-" + std::to_string(++count) + suffix;
}

/// A temporary file that replaces a file is private from the start, since the replaced file may be private.
int Passage::openTemporary(int& file) {
  const bool isPrivate = m_content.isPrivate || m_target.kind == FileTarget::Kind::File;
  const mode_t mode = isPrivate ? 0600 : 0666;
  for (int i = 0; i < mostTries; ++i) {
    const std::string name = freshName(temporarySuffix);
    file = m_calls.open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (file >= 0) {
      m_temporary = name;
      return 0;
    }
    if (errno != EEXIST) return errno;
  }
  return EEXIST;
}

int Passage::writeAll(int file) const {
  std::string_view rest = m_content.bytes;
  while (!rest.empty()) {
    const ssize_t written = m_calls.write(file, rest.data(), rest.size());
    if (written > 0)
      rest.remove_prefix(static_cast<std::size_t>(written));
    else if (written == 0 || errno != EINTR)
      return written == 0 ? EIO : errno;
  }
  return 0;
}

/// Closes the file. Returns `error` if it is not 0, else the error of closing.
int Passage::close(int file, int error) const {
  const bool isClosed = m_calls.close(file) == 0 || errno == EINTR;
  return error == 0 && !isClosed ? errno : error;
}

/// Gives the old file a second name (a hard link), from which `putBack` restores it. On a disk without hard
/// links the old file is not kept.
void Passage::keepOld() {
  if (m_target.kind != FileTarget::Kind::File) return;
  for (int i = 0; i < mostTries; ++i) {
    const std::string name = freshName(".old");
    if (link(m_target.path.c_str(), name.c_str()) == 0) {
      m_kept = name;
      return;
    }
    if (errno != EEXIST) return;
  }
}

int Passage::takePlace() {
  if (m_calls.rename(m_temporary.c_str(), m_target.path.c_str()) != 0) return errno;
  m_temporary.clear();
  m_hasPlace = true;
  return 0;
}

/// Restores the old file. If the restoration fails, returns a sentence on the file at the target's path.
std::string Passage::putBack() {
  if (!m_hasPlace) return {};
  const char* const place = m_target.path.c_str();
  if (!m_kept.empty() && m_calls.rename(m_kept.c_str(), place) == 0) {
    m_kept.clear();
    return {};
  }
  if (m_target.kind == FileTarget::Kind::New && unlink(place) == 0) return {};
  const std::string kept = std::exchange(m_kept, {});
  //: a file, one of two that belong together
  if (kept.empty()) return Phrase::of("%1 was already replaced: write both again", m_content.path);
  //: a file, one of two that belong together, and the file that its old bytes are in
  return Phrase::of("%1 was already replaced, its previous content is in %2: write both again",
                    m_content.path, kept);
}

/// An unsupported synchronisation, as for folders on some disks, is not an error.
int Passage::sync(int file) const {
  return m_calls.sync(file) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
}

int Passage::syncFolder() {
  const int folder = m_calls.open(m_target.folder().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0);
  return folder < 0 ? 0 : close(folder, sync(folder));
}

Problem unwritable(const FileContent& file, const std::string& why) {
  //: a file and why: "the disk is full: make room there or choose another folder"
  return {Phrase::of("%1 cannot be written: %2", file.path, why)};
}

std::string namedInput(const std::string& input) {
  return input == "-" ? "/dev/stdin" : input;
}

std::optional<Problem> plan(const FileContent& file, const std::vector<std::string>& inputs,
                            const FileCalls& calls, std::list<Passage>& passages) {
  Result<FileTarget> target = fileTarget(file.path);
  if (!target) return unwritable(file, target.problem().what);
  const bool isRead = std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
    return isSameFile(file.path, namedInput(input));
  });
  if (isRead) return unwritable(file, Phrase::of("this is the file being read: choose another name"));
  passages.emplace_back(file, *std::move(target), calls);
  return std::nullopt;
}

template <typename Which>
std::optional<Problem> each(std::list<Passage>& passages, const Which& which, int (Passage::*step)()) {
  for (Passage& passage : passages) {
    if (!which(passage)) continue;
    if (const int error = (passage.*step)()) return unwritable(passage.content(), whyUnwritable(error));
  }
  return std::nullopt;
}

/// Replaces all files. If one replacement fails, restores the files already replaced.
std::optional<Problem> takePlaces(std::list<Passage>& replaced) {
  if (replaced.size() > 1)
    for (Passage& passage : replaced) passage.keepOld();
  auto problem = each(
      replaced, [](const Passage&) { return true; }, &Passage::takePlace);
  if (!problem) {
    for (const Passage& passage : replaced) clearStaleFiles(passage.folder());
    return each(
        replaced, [](const Passage&) { return true; }, &Passage::syncFolder);
  }
  for (Passage& passage : replaced)
    if (const std::string remaining = passage.putBack(); !remaining.empty())
      problem->what += "; " + remaining;
  return problem;
}

}  // namespace

std::optional<Problem> writeFile(const std::string& path, std::string_view bytes,
                                 const std::vector<std::string>& inputs, const FileCalls& calls) {
  return writeFiles({{path, bytes}}, inputs, calls);
}

std::optional<Problem> writeFiles(const std::vector<FileContent>& files,
                                  const std::vector<std::string>& inputs, const FileCalls& calls) {
  std::list<Passage> passages;
  for (const FileContent& file : files)
    if (auto problem = plan(file, inputs, calls, passages)) return problem;
  const auto isDirect = [](const Passage& passage) { return passage.isDirect(); };
  const auto isReplaced = [](const Passage& passage) { return !passage.isDirect(); };
  if (auto problem = each(passages, isReplaced, &Passage::writeTemporary)) return problem;
  if (auto problem = each(passages, isDirect, &Passage::writeDirectly)) return problem;
  passages.remove_if(isDirect);
  return takePlaces(passages);
}

}  // namespace alidade
