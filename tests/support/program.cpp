#include "tests/support/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <system_error>

namespace alidade::test {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// Files instead of pipes, so that output need not be read while the program runs.
File temporaryFile() {
  File file(std::tmpfile(), &std::fclose);
  if (!file) throw std::system_error(errno, std::generic_category(), "tmpfile");
  return file;
}

std::string contentOf(std::FILE* file) {
  std::rewind(file);
  std::string content;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) content += static_cast<char>(c);
  return content;
}

[[noreturn]] void become(const ProgramCall& call, int input, int output, int errors) {
  constexpr int cannotStart = 126;
  if (!call.outputFile.empty()) output = open(call.outputFile.c_str(), O_WRONLY);
  if (!call.directory.empty() && chdir(call.directory.c_str()) != 0) _exit(cannotStart);
  for (const auto& [name, value] : call.environment) setenv(name.c_str(), value.c_str(), 1);
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  std::vector<char*> arguments = {const_cast<char*>(call.program.c_str())};
  for (const std::string& argument : call.arguments) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  execvp(call.program.c_str(), arguments.data());
  _exit(cannotStart);
}

}  // namespace

ProgramRun runProgram(const ProgramCall& call) {
  const File input = temporaryFile(), output = temporaryFile(), errors = temporaryFile();
  std::fputs(call.input.c_str(), input.get());
  std::rewind(input.get());
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) become(call, fileno(input.get()), fileno(output.get()), fileno(errors.get()));
  int status = 0;
  if (waitpid(child, &status, 0) < 0) throw std::system_error(errno, std::generic_category(), "waitpid");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contentOf(output.get()),
          contentOf(errors.get())};
}

}  // namespace alidade::test
