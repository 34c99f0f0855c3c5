#pragma once

#include <map>
#include <string>
#include <vector>

namespace alidade::test {

/// A program as a user calls it.
struct ProgramCall {
  std::string program;  ///< a path, or a name that PATH has
  std::vector<std::string> arguments;
  std::string input = {};                               ///< what it finds on stdin
  std::string directory = {};                           ///< where it runs; empty: here
  std::map<std::string, std::string> environment = {};  ///< set beside what this process has
  std::string outputFile = {};                          ///< stdout goes there and is not captured
};

struct ProgramRun {
  int exitCode = -1;  ///< 128 + signal where one ended the program
  std::string out, err;
};

/// Runs the program to its end. Throws std::system_error where it could not be started.
ProgramRun runProgram(const ProgramCall& call);

}  // namespace alidade::test
