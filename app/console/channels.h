#pragma once

#include <string>
#include <string_view>

namespace alidade::console {

/// Exit codes of the program; the only ones it ends with.
enum ExitCode { Done = 0, Failed = 1, BadInput = 2 };

/// Writes the whole result, a text or a JSON document, to stdout; what would act on a terminal or not be seen
/// there as JSON escapes it (`visibleText`), but for its line ends. `Done`, or `Failed` with a line on stderr
/// where it could not be written.
int writeResult(std::string_view result);

/// Writes `subject: message` as one line to stderr, all of it visible.
void notify(std::string_view subject, std::string_view message);

/// The same, for what cannot be used. `BadInput`.
int refuse(std::string_view subject, std::string_view reason);

/// How messages call the input: the file as it was given, or “standard input” for `-`.
std::string inputName(const std::string& file);

}  // namespace alidade::console
