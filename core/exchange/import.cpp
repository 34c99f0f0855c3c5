#include "core/exchange/import.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/limits.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/exchange/assembly.h"
#include "core/exchange/csv_reader.h"
#include "core/exchange/file_format.h"
#include "core/exchange/recognise.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

/// The layout that the names of a table's columns state, without guesses.
TableLayout asNamed(const Recognised& recognised, AngleUnit unit) {
  TableLayout layout;
  layout.unit = unit;
  if (recognised.table.headRows == 0) return layout;
  layout.separator = recognised.table.separator;
  layout.headRows = recognised.table.headRows;
  return layout;
}

/// A chosen layout applies only if the text matches no readable format.
Result<Recording> readRecording(const ReadingsFile& file, const ImportOptions& options) {
  const Result<std::string> text = readingsText(file.bytes, file.name);
  if (!text) return text.problem();
  const Result<Recognised> recognised = recognise(*text);
  if (!recognised && !file.table) return recognised.problem();
  if (recognised && !recognised->isTable()) return recognised->format->read(*text, options.zeroPoint);
  return readTable(*text, file.table ? *file.table : asNamed(*recognised, options.unit), options.zeroPoint);
}

/// The problem if `turnedAtLine` is after the last reading: no reading is at 180°.
std::optional<Problem> turnedBehindTheEnd(const Recording& recording, const ReadingsFile& file) {
  const std::size_t last = std::ranges::max_element(recording.sightings, {}, &RecordedSighting::line)->line;
  if (!file.turnedAtLine || *file.turnedAtLine <= last) return std::nullopt;
  return Problem{
      Phrase::of("has its last reading in line %1, so the readings at 180° cannot begin at line %2: give a "
                 "line within the file",
                 last, *file.turnedAtLine)};
}

Result<Recording> readFileOf(const ReadingsFile& file, const ImportOptions& options) {
  Result<Recording> recording = readRecording(file, options);
  if (!recording) return recording;
  if (recording->sightings.empty()) {
    if (!recording->problems.empty()) return Problem{recording->problems.front().text()};
    return Problem{
        Phrase::of("holds no readings with a horizontal and a vertical circle: choose another file")};
  }
  if (auto problem = turnedBehindTheEnd(*recording, file)) return *std::move(problem);
  return recording;
}

/// The problem if files differ in the kind of vertical circle from each other or from a base with readings.
std::optional<Problem> twoKindsOfCircle(const std::vector<Recording>& recordings,
                                        const ImportOptions& options) {
  const Session& base = options.base;
  const bool hasRows = std::ranges::any_of(
      base.positions, [](const Position& position) { return !position.readings.empty(); });
  const auto circle = verticalCircleEntry(base.geometry.verticalCircle);
  std::string kind;
  if (hasRows && circle) kind = keyOf(*circle);
  for (const Recording& recording : recordings) {
    if (recording.verticalCircle.empty()) continue;
    if (!kind.empty() && kind != recording.verticalCircle)
      return Problem{
          Phrase::of("has vertical readings of the kind %1, but the earlier ones are of the kind %2: a "
                     "session has one kind; import this file into a separate session",
                     plainKey(recording.verticalCircle), plainKey(kind))};
    kind = recording.verticalCircle;
  }
  return std::nullopt;
}

/// Has any sighting the name stated for the zero?
bool hasZeroPoint(const std::vector<Recording>& recordings, const std::string& name) {
  return std::ranges::any_of(recordings, [&](const Recording& recording) {
    return std::ranges::any_of(recording.sightings, [&](const RecordedSighting& sighting) {
      return isSameName(sighting.row.point, name);
    });
  });
}

}  // namespace

Result<Import> importReadings(const std::vector<ReadingsFile>& files, const ImportOptions& options) {
  std::vector<Recording> recordings;
  std::size_t rows = 0;
  for (const Position& position : options.base.positions) rows += position.readings.size();
  for (const ReadingsFile& file : files) {
    const auto named = [&](const Problem& problem) {
      return files.size() == 1 ? problem : Problem{quotation(file.name) + " " + problem.what};
    };
    Result<Recording> recording = readFileOf(file, options);
    if (!recording) return named(recording.problem());
    rows += recording->sightings.size();
    if (rows > limits::mostRows + 1) return named(limits::tooManyRows());
    recordings.push_back(*std::move(recording));
    if (const auto problem = twoKindsOfCircle(recordings, options)) return named(*problem);
  }
  if (recordings.empty()) return Problem{Phrase::of("no file was chosen: choose one")};
  const bool lacksZeroPoint = !options.zeroPoint.empty() && !hasZeroPoint(recordings, options.zeroPoint);
  Import import = assemble(std::move(recordings), files, options);
  if (lacksZeroPoint) {
    import.missingZeroPoint =
        Phrase::of("no sighting is named %1: state the name of the pointing zero as in the file",
                   quotation(options.zeroPoint));
    import.remarks.push_back(import.missingZeroPoint);
  }
  return import;
}

}  // namespace alidade
