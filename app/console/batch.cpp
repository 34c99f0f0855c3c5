#include "app/console/batch.h"

#include <condition_variable>
#include <initializer_list>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/console/channels.h"
#include "core/base/failure.h"
#include "core/base/threads.h"
#include "core/base/visible_text.h"
#include "core/exchange/csv_text.h"

namespace alidade::console {

namespace {

struct Answered {
  std::string text;
  std::optional<std::string> reason = {};  ///< why there is no result
  bool failed = false;                     ///< the reason is a fault or a lack of memory, not the input
};

std::string quoted(const std::string& text) {
  return nlohmann::json(wellFormed(text)).dump();
}

std::string asLine(const std::string& file, const Answered& answered) {
  const std::string begin = "{\"file\": " + quoted(file) + ", ";
  if (answered.reason) return begin + "\"error\": " + quoted(*answered.reason) + "}\n";
  const std::string line = onOneLine(answered.text);
  return begin + line.substr(1) + "\n";
}

std::string cellOf(const std::string& file) {
  CsvText cell(std::initializer_list<std::string_view>{});
  cell.typed(file).endRow();
  return cell.text().substr(cell.text().find('\n') + 1);
}

/// The rows of a table, each preceded by the name of its file. The column names are kept only if `isFirst`.
std::string asRows(const std::string& file, const std::string& table, bool isFirst) {
  std::string cell = cellOf(file), rows;
  cell.back() = ',';
  for (std::size_t from = 0, end = 0; from < table.size(); from = end) {
    end = table.find('\n', from) + 1;
    if (from > 0) rows += cell;
    if (from > 0 || isFirst) rows += (from > 0 ? "" : "file,") + table.substr(from, end - from);
  }
  return rows;
}

/// Receives results in any order and writes them in input order.
class OrderedOutput {
 public:
  OrderedOutput(const std::vector<ListedFile>& files, const BatchOptions& options)
      : m_files(files), m_options(options), m_waiting(kept), m_progress(options.progress) {}

  /// Waits while `index` is at least `kept` ahead of the output. False if writing is no longer possible.
  bool awaitTurn(std::size_t index) {
    std::unique_lock lock(m_guard);
    m_moved.wait(lock, [&] { return m_broken || index < m_written + kept; });
    return !m_broken;
  }

  void take(std::size_t index, Answered answered) {
    const std::scoped_lock lock(m_guard);
    m_waiting[index % kept] = std::move(answered);
    for (auto* next = &m_waiting[m_written % kept]; !m_broken && *next; next = &m_waiting[m_written % kept]) {
      write(m_files[m_written].path, **next);
      next->reset();
      ++m_written;
    }
    if (m_progress.isDue()) report();
    m_moved.notify_all();
  }

  int finish() {
    if (!m_broken && m_progress.isShown()) report();
    return m_broken || m_failed ? Failed : m_unusable > 0 ? BadInput : Done;
  }

 private:
  /// The largest number of results that wait in memory for an earlier, slower session.
  static constexpr std::size_t kept = 256;

  const std::vector<ListedFile>& m_files;
  const BatchOptions m_options;
  std::mutex m_guard;
  std::condition_variable m_moved;
  std::vector<std::optional<Answered>> m_waiting;
  ProgressLines m_progress;
  std::size_t m_written = 0, m_unusable = 0;
  bool m_broken = false, m_failed = false, m_hasText = false;

  void report() const {
    std::string line = std::to_string(m_written) + " of " + std::to_string(m_files.size()) + " files done";
    if (m_unusable > 0) line += ", " + std::to_string(m_unusable) + " of them without a result";
    notify("alidade-cli", line);
  }

  void write(const std::string& file, const Answered& answered) {
    if (answered.reason) {
      ++m_unusable;
      m_failed = m_failed || answered.failed;
      notify(inputName(file), *answered.reason);
    }
    std::string text;
    if (m_options.json)
      text = asLine(file, answered);
    else if (!answered.reason && m_options.table)
      text = asRows(file, answered.text, !std::exchange(m_hasText, true));
    else if (!answered.reason)
      text = (std::exchange(m_hasText, !m_options.lines) ? "\n" : "") + answered.text;
    if (!text.empty() && writeResult(text) != Done) m_broken = true;
  }
};

Answered answerTo(const ListedFile& file,
                  const std::function<Result<std::string>(const std::string& file)>& answer) {
  if (file.problem) return {{}, file.problem->text()};
  Answered answered;
  const auto failure = failureOf([&] {
    Result<std::string> given = answer(file.path);
    if (given)
      answered.text = *std::move(given);
    else
      answered.reason = given.problem().text();
  });
  if (failure) return {{}, "the command failed: " + *failure, true};
  return answered;
}

}  // namespace

int answerEach(const std::vector<std::string>& named,
               const std::function<Result<std::string>(const std::string& file)>& answer,
               const BatchOptions& options) {
  return answerEach(sessionFilesOf(named), answer, options);
}

int answerEach(const SessionFiles& list,
               const std::function<Result<std::string>(const std::string& file)>& answer,
               const BatchOptions& options) {
  for (const std::string& path : list.again) notify(inputName(path), "is named again: answered once");
  OrderedOutput output(list.files, options);
  doEach(threadsOrAll(options.threads), list.files.size(), [&](std::size_t i) {
    if (output.awaitTurn(i)) output.take(i, answerTo(list.files[i], answer));
  });
  return output.finish();
}

std::string onOneLine(std::string_view document) {
  std::string line;
  line.reserve(document.size());
  for (std::size_t i = 0; i < document.size(); ++i) {
    if (document[i] != '\n') {  // JSON escapes line breaks within strings
      line += document[i];
      continue;
    }
    const bool betweenMembers = !line.empty() && line.back() == ',';
    while (i + 1 < document.size() && document[i + 1] == ' ') ++i;
    if (betweenMembers) line += ' ';
  }
  return line;
}

}  // namespace alidade::console
