#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/console/session_files.h"
#include "core/base/result.h"

namespace alidade::console {

struct BatchOptions {
  std::size_t threads = 0;  ///< 0: one per processor core; the results are the same for any number
  bool progress = false;    ///< prints progress on stderr even without a terminal
  bool json = false;
  bool jsonLines = false;  ///< `json`, one line each for a single file, too
  bool lines = false;      ///< the results are one line each, with no empty line between
  bool table = false;  ///< the results are tables (CSV) of the same columns, whose cells hold no line ends
};

/// Processes each input of a call (`sessionFilesOf`) separately and in parallel, and writes the results to
/// stdout in input order.
/// JSON results (`answer` returns one document each) take one line each, which begins with the key `file`; an
/// unusable input has the keys `file` and `error`. Tables are joined into one, whose first column is the
/// file. Texts are separated by an empty line.
/// An unusable input also gets one line on stderr; the others continue, and the exit code is `BadInput`.
/// Memory holds a limited number of results.
int answerEach(const std::vector<std::string>& named,
               const std::function<Result<std::string>(const std::string& file)>& answer,
               const BatchOptions& options);
/// `answerEach` for inputs that are already listed.
int answerEach(const SessionFiles& list,
               const std::function<Result<std::string>(const std::string& file)>& answer,
               const BatchOptions& options);

/// A JSON document on one line.
std::string onOneLine(std::string_view document);

}  // namespace alidade::console
