#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "core/base/file_bytes.h"
#include "tests/fuzz/targets.h"

namespace alidade::fuzz {

void PrintTo(const Target& target, std::ostream* out) {
  *out << target.name;
}

namespace {

std::vector<std::string> filesOf(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().filename() != "README.md") files.push_back(entry.path().string());
  std::ranges::sort(files);
  return files;
}

/// File names converted to valid GoogleTest names.
std::string testName(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return text;
}

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, GoesThrough) {
  const std::vector<std::string> files = filesOf(ALIDADE_CORPUS_DIR "/" + std::string(GetParam().name));
  ASSERT_FALSE(files.empty());
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    EXPECT_NO_THROW(GetParam().run(*readFile(file)));
  }
}

INSTANTIATE_TEST_SUITE_P(, Corpus, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& target) { return std::string(target.param.name); });

/// Sessions that once crashed the program.
class OnceFatal : public testing::TestWithParam<std::string> {};

TEST_P(OnceFatal, EndsInAnAnswerOrASentence) {
  EXPECT_NO_THROW(throwSession(*readFile(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(, OnceFatal, testing::ValuesIn(filesOf(ALIDADE_REFERENCE_DIR "/once-fatal")),
                         [](const auto& file) {
                           return testName(std::filesystem::path(file.param).stem().string());
                         });

}  // namespace

}  // namespace alidade::fuzz
