#include "app/console/other_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace alidade::console {

namespace {

Problem cannotStart(const std::string& program, int error) {
  return Problem{program + " cannot be started: " + std::strerror(error)};
}

/// Reads from a pipe until its other end is closed.
std::string readAll(int end) {
  std::string text;
  std::array<char, 4096> part{};
  for (;;) {
    const ssize_t count = read(end, part.data(), part.size());
    if (count > 0)
      text.append(part.data(), static_cast<std::size_t>(count));
    else if (count == 0 || errno != EINTR)
      return text;
  }
}

int exitCodeOf(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

Result<std::string> installedProgram(const std::string& name) {
  std::error_code problem;
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", problem);
  const std::filesystem::path program = own.parent_path() / name;
  if (problem || access(program.c_str(), X_OK) != 0)
    return Problem{"this needs the program " + name + " in the folder of alidade-cli: install it there"};
  return program.string();
}

Result<ProgramEnd> runToEnd(const std::string& program, const std::vector<std::string>& arguments) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return cannotStart(program, errno);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  std::vector<char*> all{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) all.push_back(const_cast<char*>(argument.c_str()));
  all.push_back(nullptr);
  pid_t process = 0;
  const int error = posix_spawn(&process, program.c_str(), &actions, nullptr, all.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  ProgramEnd end;
  if (error == 0) end.errors = readAll(ends[0]);
  close(ends[0]);
  if (error != 0) return cannotStart(program, error);
  end.exitCode = exitCodeOf(process);
  return end;
}

}  // namespace alidade::console
