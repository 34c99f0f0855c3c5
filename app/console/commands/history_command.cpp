#include "app/console/commands/history_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <optional>

#include "app/console/channels.h"
#include "app/console/commands/option_checks.h"
#include "app/console/commands/shared_options.h"
#include "app/console/history_text.h"
#include "app/console/session_files.h"
#include "core/base/clock.h"
#include "core/base/failure.h"
#include "core/base/file_bytes.h"
#include "core/base/threads.h"
#include "core/base/visible_text.h"
#include "core/series/history/history_json.h"
#include "core/series/history/history_sentences.h"
#include "core/series/history/series_file.h"
#include "core/session/instrument_record.h"
#include "core/session/session_file.h"
#include "core/wording/series_words.h"

namespace alidade::console {

namespace {

bool isFolder(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

bool isSession(const std::string& path) {
  return std::filesystem::path(path).extension() == ".alidade";
}

bool isRecord(const std::string& path) {
  return std::filesystem::path(path).extension() == ".alidade-instrument";
}

/// The instrument records of a folder, sorted by path; none if the folder holds a session.
std::vector<std::string> recordsIn(const std::string& folder) {
  std::vector<std::string> records;
  std::error_code problem;
  std::filesystem::directory_iterator entry(folder, problem);
  for (; !problem && entry != std::filesystem::directory_iterator(); entry.increment(problem)) {
    const std::string path = entry->path().string();
    if (isSession(path) && !isFolder(path)) return {};
    if (isRecord(path) && !isFolder(path)) records.push_back(path);
  }
  std::ranges::sort(records);
  return records;
}

std::string baseName(const std::string& file) {
  std::filesystem::path path(inputName(file));
  if (!path.has_filename()) path = path.parent_path();
  return wellFormed(path.filename().string());
}

class Histories {
 public:
  explicit Histories(const HistoryRequest& request) : m_request(request) {}

  int give() {
    std::vector<std::string> sessions, records;
    SessionFiles inputs;
    for (const std::string& file : m_request.files)
      if (isFolder(file) || (!isSession(file) && !isRecord(file)))
        inputs.files.push_back({file});
      else
        (isSession(file) ? sessions : records).push_back(file);
    const bool isOneGroup = inputs.files.empty() && (sessions.empty() || records.empty());
    for (const auto& [files, what] : {std::pair(&sessions, "sessions"), std::pair(&records, "records")})
      if (!files->empty()) inputs.files.push_back({nameOf(*files, what)});
    const auto answer = [&](const std::string& input) -> Result<std::string> {
      if (!sessions.empty() && input == nameOf(sessions, "sessions")) return ofSessions(input, sessions);
      if (!records.empty() && input == nameOf(records, "records")) return ofRecords(input, records);
      return ofInput(input);
    };
    if (inputs.files.size() == 1) {
      const std::string& input = inputs.files.front().path;
      return giveOne(isOneGroup ? "" : inputName(input), [&] { return answer(input); });
    }
    const int code = answerEach(inputs, answer, m_request.batch);
    return code == Done && m_isAnyUnusable ? BadInput : code;
  }

 private:
  const HistoryRequest& m_request;
  std::atomic<bool> m_isAnyUnusable = false;

  static std::string nameOf(const std::vector<std::string>& files, const std::string& what) {
    return files.size() == 1 ? files.front() : std::to_string(files.size()) + " " + what;
  }

  template <class Answer>
  int giveOne(const std::string& subject, const Answer& answer) {
    const Result<std::string> given = answer();
    if (!given) return refuse(subject.empty() ? "alidade-cli" : subject, given.problem().text());
    const int code = writeResult(*given);
    return code == Done && m_isAnyUnusable ? BadInput : code;
  }

  Result<std::string> ofInput(const std::string& input) {
    if (isSeriesPath(input)) return ofSeries(input);
    if (isFolder(input)) {
      const std::vector<std::string> records = recordsIn(input);
      return records.empty() ? ofSessions(baseName(input), {input}) : ofRecords(baseName(input), records);
    }
    const Result<std::string> bytes = input == "-" ? readStandardInput() : readFile(input);
    if (!bytes) return bytes.problem();
    if (bytes->find_first_not_of(" \t\r\n") != std::string::npos &&
        (*bytes)[bytes->find_first_not_of(" \t\r\n")] == '{')
      return Problem{"is no table of values: name the folder of the sessions, or sessions (*.alidade)"};
    const Result<ValueTable> table = readValueTable(*bytes);
    if (!table) return table.problem();
    History history = historyOf(table->values);
    if (auto problem = baselineProblem(history.values.size(), "values")) return *std::move(problem);
    setBaseline(history, m_request.baseline);
    const std::string name = baseName(input);
    return m_request.batch.json ? historyJson(name, *table, history) : historyText(name, *table, history);
  }

  std::optional<Problem> baselineProblem(std::size_t count, const std::string& what) const {
    if (m_request.baseline <= count) return std::nullopt;
    return Problem{"--baseline " + std::to_string(m_request.baseline) + " is more than there are: " + what +
                   " " + std::to_string(count)};
  }

  Result<std::string> ofSeries(const std::string& input) {
    const Result<SeriesFile> series = loadSeriesFile(input);
    if (!series) return series.problem();
    return ofSessions(baseName(input), series->sessions, series->baseline);
  }

  Result<std::string> ofRecords(const std::string& name, const std::vector<std::string>& files) {
    std::vector<KeptRecord> records;
    std::vector<std::string> remarks;
    for (const std::string& file : files) {
      const Result<InstrumentRecord> record = loadInstrumentRecord(file);
      if (record) {
        records.push_back({baseName(file), *record});
        continue;
      }
      m_isAnyUnusable = true;
      notify(file, record.problem().text());
      remarks.push_back(wellFormed(file) + ": " + record.problem().text());
    }
    if (records.empty()) return Problem{"none of the records can be used: see the lines above"};
    InstrumentHistories histories = instrumentHistories(records);
    for (const auto& [copy, first] : histories.copies) {
      remarks.push_back(records[copy].file + " holds the same record as " + records[first].file +
                        ": counted once.");
      notify(records[copy].file, "holds the same record as " + records[first].file + ": counted once");
    }
    for (InstrumentHistory& instrument : histories.instruments) {
      if (auto problem = baselineProblem(instrument.records.size(), "records")) return *std::move(problem);
      setBaseline(instrument, m_request.baseline);
    }
    return m_request.batch.json ? historyJson(name, histories, remarks)
                                : historyText(name, histories, localDay());
  }

  Result<std::string> ofSessions(const std::string& name, const std::vector<std::string>& named,
                                 std::size_t baseline = 0) {
    const SessionFiles list = sessionFilesOf(named);
    for (const std::string& again : list.again) notify(inputName(again), "is named again: counted once");
    if (list.files.size() == 1 && list.files.front().problem && list.files.front().path == named.front())
      return *list.files.front().problem;
    std::vector<std::string> remarks;
    std::vector<Epoch> epochs = load(list.files, remarks);
    if (epochs.empty()) return Problem{"none of the sessions can be used: see the lines above"};
    DeviceHistories histories = deviceHistories(epochs);
    for (DeviceHistory& device : histories.devices) {
      if (auto problem = baselineProblem(device.epochs.size(), "sessions")) return *std::move(problem);
      setBaseline(device, m_request.baseline > 0 ? m_request.baseline : baseline);
    }
    for (const auto& [copy, first] : histories.copies) {
      remarks.push_back(copySentence(epochs[copy].file, epochs[first].file));
      notify(epochs[copy].file, copyReason(epochs[copy].file, epochs[first].file));
    }
    for (const std::size_t undated : histories.undated) {
      remarks.push_back(undatedSentence(epochs[undated].title));
      notify(epochs[undated].file, "has no date and takes no part: enter the day it was measured on");
    }
    if (histories.devices.empty())
      return Problem{"no session has a date: enter the day each was measured on (measured_on)"};
    return m_request.batch.json ? historyJson(name, histories, remarks) : historyText(name, histories);
  }

  /// Reads the files. Returns the epochs of the usable files in order, and reports the other files.
  std::vector<Epoch> load(const std::vector<ListedFile>& files, std::vector<std::string>& remarks) {
    std::vector<std::optional<Epoch>> loaded(files.size());
    std::vector<std::string> reasons(files.size());
    doEach(threadsOrAll(m_request.batch.threads), files.size(), [&](std::size_t i) {
      const auto failure = failureOf([&] {
        Result<Epoch> epoch = files[i].problem ? Result<Epoch>(*files[i].problem) : loadEpoch(files[i].path);
        if (epoch)
          loaded[i] = *std::move(epoch);
        else
          reasons[i] = epoch.problem().text();
      });
      if (failure) reasons[i] = "the command failed: " + *failure;
    });
    std::vector<Epoch> epochs;
    for (std::size_t i = 0; i < files.size(); ++i) {
      if (loaded[i]) {
        epochs.push_back(*std::move(loaded[i]));
        continue;
      }
      m_isAnyUnusable = true;
      notify(inputName(files[i].path), reasons[i]);
      remarks.push_back(wellFormed(files[i].path) + ": " + reasons[i]);
    }
    return epochs;
  }
};

}  // namespace

void addHistoryCommand(CLI::App& app, HistoryRequest& request) {
  CLI::App* history = app.add_subcommand(
      "history",
      "One device, or one constant of an instrument, over time: is it the same, and if not, since "
      "when.");
  history
      ->add_option(
          "FOLDER|VALUES.csv", request.files,
          "Sessions (*.alidade), a folder or a series (*.alidade-series) of them; instrument records "
          "(*.alidade-instrument) or a folder of them; or a table of date, value and standard "
          "uncertainty; - reads such a table from standard input")
      ->required();
  history
      ->add_option(
          "--baseline", request.baseline,
          "The first N sessions, records or values set the centre line and the limits, which watch the later "
          "ones; else all set them")
      ->check(wholeFrom(1, 100000));
  addBatchOptions(*history, request.batch);
}

int giveHistory(const HistoryRequest& request) {
  return Histories(request).give();
}

}  // namespace alidade::console
