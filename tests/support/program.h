#pragma once

#include <map>
#include <string>
#include <vector>

namespace alidade::test {

/// A program call as by a user.
struct ProgramCall {
  std::string program;  ///< a path, or a name found through PATH
  std::vector<std::string> arguments;
  std::string input = {};                               ///< its stdin
  std::string directory = {};                           ///< working directory; empty: the current one
  std::map<std::string, std::string> environment = {};  ///< in addition to that of this process
  std::string outputFile = {};                          ///< receives stdout, which is then not captured
};

struct ProgramRun {
  int exitCode = -1;  ///< 128 + signal if a signal ended the program
  std::string out, err;
};

/// Runs the program to its end. Throws std::system_error if it could not be started.
ProgramRun runProgram(const ProgramCall& call);

}  // namespace alidade::test
