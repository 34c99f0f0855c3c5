#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace alidade::test {

inline std::string contentOf(const std::filesystem::path& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

}  // namespace alidade::test
