#include "core/series/history/series_file.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/file_bytes.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/session/json_object_reader.h"
#include "core/session/json_text.h"

namespace alidade {

namespace {

namespace fs = std::filesystem;

constexpr JsonFormat seriesFormat = {
    "alidade-series",
    PHRASE_LATER("Phrase",
                 "is missing, so this is no series: choose a file with \"format\": \"alidade-series\""),
    PHRASE_LATER("Phrase", "choose a series of sessions"),
    PHRASE_LATER("Phrase", "%1 is no version of a series: it must be %2")};

}  // namespace

bool isSeriesPath(std::string_view path) {
  return fs::path(path).extension() == seriesSuffix;
}

Result<SeriesFile> readSeriesFile(std::string_view text) {
  nlohmann::ordered_json json;
  if (auto problem = parseJson(text, json)) return *std::move(problem);
  std::optional<Problem> problem;
  const ObjectReader reader(json, {}, problem);
  reader.checkFormat(seriesFormat);
  reader.require("sessions", PHRASE_LATER("Phrase", "add the paths of the sessions"));
  SeriesFile series;
  for (const auto& session : reader.list("sessions")) {
    if (session.is_string() && !session.get_ref<const std::string&>().empty())
      series.sessions.push_back(session);
    else
      reader.report(Phrase::of("each must be the path of a session in quotation marks"),
                    reader.placeOf("sessions"));
  }
  const std::string baseline = reader.number("baseline_sessions");
  const Result<double> number = parseNumber(baseline.empty() ? "0" : baseline);
  constexpr double most = 1e6;
  if (!number || *number < 0 || *number > most || *number != static_cast<double>(static_cast<long>(*number)))
    reader.report(Phrase::of("must be a whole number of sessions, 0 to 1 000 000"),
                  reader.placeOf("baseline_sessions"));
  else
    series.baseline = static_cast<std::size_t>(*number);
  if (problem) return *problem;
  if (series.sessions.empty()) return Problem{Phrase::of("the series names no session: add one")};
  return series;
}

std::string writeSeriesFile(const SeriesFile& series) {
  nlohmann::ordered_json json = {{"format", seriesFormat.id}, {"version", 1}, {"sessions", series.sessions}};
  if (series.baseline > 0) json["baseline_sessions"] = series.baseline;
  return json.dump(2) + "\n";
}

Result<SeriesFile> loadSeriesFile(const std::string& path) {
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.problem();
  const Result<SeriesFile> read = readSeriesFile(*bytes);
  if (!read) return read.problem();
  SeriesFile series = *read;
  for (std::string& session : series.sessions)
    session = (fs::path(path).parent_path() / session).lexically_normal().string();
  return series;
}

std::string pathInSeries(const std::string& session, const std::string& seriesPath) {
  std::error_code ignored;
  const fs::path folder = fs::absolute(seriesPath, ignored).parent_path();
  return fs::absolute(session, ignored)
      .lexically_normal()
      .lexically_relative(folder.lexically_normal())
      .generic_string();
}

}  // namespace alidade
