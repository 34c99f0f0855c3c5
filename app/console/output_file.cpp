#include "app/console/output_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace alidade::console {

std::optional<Problem> writeFile(const std::string& path, const std::string& text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (file) return std::nullopt;
  return Problem{path + " cannot be written (" + std::strerror(errno) + "): choose another name or folder"};
}

}  // namespace alidade::console
