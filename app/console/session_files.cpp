#include "app/console/session_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <unordered_set>

#include "core/series/history/series_file.h"

namespace alidade::console {

namespace {

namespace fs = std::filesystem;

constexpr const char* sessionSuffix = ".alidade";

bool isFolder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

/// True for a pipe, a socket, a device or a link to one of these: reading may block forever. False for a
/// missing path: opening the path reports the problem.
bool isEndless(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

/// The canonical path of the file, equal for all its paths; `path` itself if the file cannot be found.
std::string realName(const std::string& path) {
  std::error_code problem;
  const fs::path real = fs::canonical(path, problem);
  return problem ? path : real.string();
}

class Listing {
 public:
  SessionFiles of(const std::vector<std::string>& named) {
    for (const std::string& path : named)
      if (isFolder(path))
        addFolder(path);
      else if (isSeriesPath(path))
        addSeries(path);
      else
        add(path, path == "-" ? path : realName(path));
    return std::move(m_list);
  }

 private:
  SessionFiles m_list;
  std::unordered_set<std::string> m_seen;

  void add(const std::string& path, std::string real) {
    if (m_seen.insert(std::move(real)).second)
      m_list.files.push_back({path});
    else
      m_list.again.push_back(path);
  }

  void addSeries(const std::string& path) {
    const Result<SeriesFile> series = loadSeriesFile(path);
    if (!series)
      m_list.files.push_back({path, series.problem()});
    else
      for (const std::string& session : series->sessions) add(session, realName(session));
  }

  void addFolder(const std::string& folder) {
    std::error_code problem;
    std::vector<fs::path> found;
    fs::directory_iterator entry(folder, problem);
    for (; !problem && entry != fs::directory_iterator(); entry.increment(problem)) {
      const fs::path& path = entry->path();
      if (path.extension() == sessionSuffix && !path.filename().string().starts_with('.') &&
          !isFolder(path.string()))
        found.push_back(path);
    }
    if (problem)
      m_list.files.push_back(
          {folder, Problem{"the folder cannot be read (" + problem.message() + "): check your rights"}});
    else if (found.empty())
      m_list.files.push_back({folder, Problem{"the folder holds no session (*.alidade): choose another"}});
    std::ranges::sort(found);
    const fs::path real = realName(folder);
    for (const fs::path& path : found) {
      if (isEndless(path)) {
        m_list.files.push_back({path.string(), Problem{"is a pipe, a socket or a device: move it "
                                                       "out of the folder, or name it by itself"}});
        continue;
      }
      std::error_code ignored;
      add(path.string(),
          fs::is_symlink(path, ignored) ? realName(path.string()) : (real / path.filename()).string());
    }
  }
};

}  // namespace

SessionFiles sessionFilesOf(const std::vector<std::string>& named) {
  return Listing().of(named);
}

bool namesMany(const std::vector<std::string>& named) {
  return named.size() > 1 || (named.size() == 1 && (isFolder(named.front()) || isSeriesPath(named.front())));
}

}  // namespace alidade::console
