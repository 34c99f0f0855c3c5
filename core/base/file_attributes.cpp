#include "core/base/atomic_file.h"

#include <sys/xattr.h>

#include <optional>
#include <string_view>

namespace alidade {

namespace {

constexpr const char* accessList = "system.posix_acl_access";

/// The names of the extended attributes, each terminated by a zero; empty if there are none.
std::string attributeNames(const std::string& path) {
  const ssize_t size = listxattr(path.c_str(), nullptr, 0);
  if (size <= 0) return {};
  std::string names(static_cast<std::size_t>(size), '\0');
  const ssize_t read = listxattr(path.c_str(), names.data(), names.size());
  names.resize(read > 0 ? static_cast<std::size_t>(read) : 0);
  return names;
}

std::optional<std::string> attribute(const std::string& path, const char* name) {
  const ssize_t size = getxattr(path.c_str(), name, nullptr, 0);
  if (size < 0) return {};
  std::string value(static_cast<std::size_t>(size), '\0');
  const ssize_t read = getxattr(path.c_str(), name, value.data(), value.size());
  if (read < 0) return {};
  value.resize(static_cast<std::size_t>(read));
  return value;
}

}  // namespace

bool copyFileAttributes(const std::string& from, int to) {
  bool isAccessKept = true;
  fremovexattr(to, accessList);
  const std::string names = attributeNames(from);
  for (std::size_t at = 0; at < names.size(); at = names.find('\0', at) + 1) {
    const char* name = names.c_str() + at;
    const auto value = attribute(from, name);
    const bool isCopied = value && fsetxattr(to, name, value->data(), value->size(), 0) == 0;
    if (name == std::string_view(accessList)) isAccessKept = isCopied;
  }
  return isAccessKept;
}

}  // namespace alidade
