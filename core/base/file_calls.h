#pragma once

#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <cstdio>
#include <functional>

namespace alidade {

/// The system calls for writing a file. Each returns the system's result, including errno; a test can make
/// one fail.
struct FileCalls {
  std::function<int(const char* path, int flags, mode_t mode)> open =
      [](const char* path, int flags, mode_t mode) { return ::open(path, flags, mode); };
  std::function<ssize_t(int file, const void* bytes, std::size_t count)> write = ::write;
  std::function<int(int file)> sync = ::fsync;
  std::function<int(int file)> close = ::close;
  std::function<int(const char* from, const char* to)> rename = std::rename;
};

}  // namespace alidade
