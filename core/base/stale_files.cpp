#include "core/base/atomic_file.h"

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

namespace alidade {

namespace {

namespace fs = std::filesystem;

/// The process in `.alidade-4711-1.tmp`; absent for other names.
std::optional<pid_t> processIn(std::string_view name) {
  constexpr std::string_view head = ".alidade-";
  if (!name.starts_with(head) || !name.ends_with(temporarySuffix)) return {};
  name.remove_prefix(head.size());
  name.remove_suffix(std::string_view(temporarySuffix).size());
  pid_t process = 0;
  unsigned count = 0;
  const char* const end = name.data() + name.size();
  const auto [dash, trouble] = std::from_chars(name.data(), end, process);
  if (trouble != std::errc() || dash == end || *dash != '-' || process <= 0) return {};
  const auto [last, further] = std::from_chars(dash + 1, end, count);
  return further == std::errc() && last == end ? std::optional(process) : std::nullopt;
}

/// Is the file abandoned? Its process may run on another machine: the file must also be an hour old.
bool isStale(const fs::path& path) {
  constexpr time_t patience = 3600;
  const auto process = processIn(path.filename().string());
  struct stat status = {};
  if (!process || lstat(path.c_str(), &status) != 0) return false;
  return S_ISREG(status.st_mode) && status.st_uid == geteuid() &&
         status.st_mtime + patience < time(nullptr) && kill(*process, 0) != 0 && errno == ESRCH;
}

}  // namespace

void clearStaleFiles(const std::string& folder) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (isStale(entry->path())) unlink(entry->path().c_str());
}

}  // namespace alidade
