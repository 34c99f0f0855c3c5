#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/console/session_files.h"
#include "core/base/result.h"

namespace alidade::console {

struct BatchOptions {
  std::size_t threads = 0;  ///< 0: all. The result does not depend on it
  bool progress = false;    ///< told on stderr even where that is no terminal
  bool json = false;
};

/// In how many threads to work, 1 or more.
std::size_t threadsOf(const BatchOptions& options);

/// Answers each input that a call names (`sessionFilesOf`) by itself, in parallel, and writes the answers to
/// stdout in the order of the inputs. As JSON (`answer` gives one document): one line for each, which begins
/// with the key `file`; of an input that cannot be used it has `file` and `error`. As text: one after the
/// other, an empty line between them. An input that cannot be used gets one line on stderr, too, and the
/// others go on; the exit code then is `BadInput`. Only some answers are kept at a time, however many there
/// are.
int answerEach(const std::vector<std::string>& named,
               const std::function<Result<std::string>(const std::string& file)>& answer,
               const BatchOptions& options);
/// The same of inputs that were listed before.
int answerEach(const SessionFiles& list,
               const std::function<Result<std::string>(const std::string& file)>& answer,
               const BatchOptions& options);

/// A JSON document on one line.
std::string onOneLine(std::string_view document);

}  // namespace alidade::console
