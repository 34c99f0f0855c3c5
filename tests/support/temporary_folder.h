#pragma once

#include <filesystem>
#include <string>

namespace alidade::test {

/// A separate folder for one test, removed with this object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return m_path; }

  /// Writes `content` to a file of that name and returns its path.
  std::string file(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path m_path;
};

}  // namespace alidade::test
