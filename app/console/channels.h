#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace alidade::console {

/// All exit codes of the program. `Rejected` and `Undecided` occur only on request (`VerdictExit`).
enum ExitCode { Done = 0, Failed = 1, BadInput = 2, Rejected = 3, Undecided = 4 };

/// Writes the whole result, a text or a JSON document, to stdout. Control or invisible characters are escaped
/// as in JSON (`visibleText`), except line ends. Returns `Done`, or `Failed` with a line on stderr if writing
/// failed.
int writeResult(std::string_view result);

/// Writes `subject: message` as one line to stderr, with invisible characters escaped.
void notify(std::string_view subject, std::string_view message);

/// Lines on the progress of long work: on stderr, if wanted or at a terminal, and at most one in a second.
class ProgressLines {
 public:
  explicit ProgressLines(bool wanted);

  bool isShown() const { return m_shown; }
  /// Whether a line is due; the next one is then due in a second.
  bool isDue();

 private:
  bool m_shown;
  std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
};

/// Reports an unusable input by `notify`; returns `BadInput`.
int refuse(std::string_view subject, std::string_view reason);

/// The name of the input in messages: the file as given, or “standard input” for `-`.
std::string inputName(const std::string& file);

}  // namespace alidade::console
