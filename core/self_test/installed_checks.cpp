#include <filesystem>
#include <string>

#include "core/base/file_bytes.h"
#include "core/base/phrase.h"
#include "core/base/sha256.h"
#include "core/self_test/check_families.h"
#include "core/self_test/references.h"
#include "core/self_test/self_test.h"

namespace alidade {

namespace {

constexpr const char* byHash = PHRASE_LATER("Phrase", "SHA-256 of the whole file");

std::string hashOf(const std::string& path) {
  const Result<std::string> bytes = readFile(path);
  return bytes ? sha256(*bytes) : bytes.problem().text();
}

}  // namespace

std::vector<SelfCheck> installedChecks(const std::string& share) {
  constexpr auto group = CheckGroup::Installed;
  if (share.empty())
    return {{.group = group,
             .name = "share/alidade",
             .reason = PHRASE_LATER("Phrase", "the program does not run from where it was installed"),
             .outcome = SelfCheck::Outcome::LeftOut}};
  std::vector<SelfCheck> checks;
  for (const InstalledFile& file : installedFiles()) {
    const std::string path(file.path);
    std::string where = share;
    where += '/';
    where += path;
    checks.push_back(hashCheck(group, path, std::string(file.sha256), hashOf(where), byHash));
  }
  return checks;
}

std::string installedShare() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error || program.parent_path().filename() != "bin") return {};
  const std::filesystem::path share = program.parent_path().parent_path() / "share";
  return std::filesystem::is_directory(share / "alidade", error) ? share.string() : std::string();
}

}  // namespace alidade
