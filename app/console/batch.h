#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/console/session_files.h"
#include "core/base/result.h"

namespace alidade::console {

struct BatchOptions {
  std::size_t threads = 0;  ///< 0: all. The result is independent of it
  bool progress = false;    ///< printed on stderr even without a terminal
  bool json = false;
  bool lines = false;  ///< the results are one line each, with no empty line between
  bool table = false;  ///< the results are tables (CSV) of the same columns, whose cells hold no line ends
};

/// The number of threads to use, 1 or more.
std::size_t threadsOf(const BatchOptions& options);

/// Processes each input of a call (`sessionFilesOf`) separately and in parallel, and writes the results to
/// stdout in input order.
/// As JSON (`answer` gives one document): one line each, beginning with the key `file`; for an unusable input
/// `file` and `error`. As tables: one with all rows, the file before each. As text: one after the other,
/// separated by an empty line.
/// An unusable input also gets one line on stderr; the others continue, and the exit code is `BadInput`.
/// Memory holds a limited number of results.
int answerEach(const std::vector<std::string>& named,
               const std::function<Result<std::string>(const std::string& file)>& answer,
               const BatchOptions& options);
/// The same for inputs listed before.
int answerEach(const SessionFiles& list,
               const std::function<Result<std::string>(const std::string& file)>& answer,
               const BatchOptions& options);

/// A JSON document on one line.
std::string onOneLine(std::string_view document);

}  // namespace alidade::console
