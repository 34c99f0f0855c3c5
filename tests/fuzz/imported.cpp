#include "tests/fuzz/imported.h"

#include <algorithm>
#include <vector>

#include "core/base/utf8.h"
#include "core/exchange/text_lines.h"
#include "core/session/measurement.h"
#include "core/session/session_file.h"
#include "tests/fuzz/require.h"

namespace alidade::fuzz {

namespace {

std::vector<TextLine> linesOf(std::string_view text) {
  std::vector<TextLine> all;
  TextLines lines(text);
  while (const auto line = lines.next()) all.push_back(*line);
  return all;
}

void checkPlace(const LineProblem& problem, const std::vector<TextLine>& lines) {
  require(!problem.what.empty() && !firstIllFormedByte(problem.what), "a problem without words");
  require(problem.line >= 1 && problem.line <= lines.size(), "a line that is not there: " + problem.text());
  const std::size_t characters = characterCount(lines[problem.line - 1].text);
  require(problem.column <= characters + 1, "a column that is not there: " + problem.text());
}

}  // namespace

void checkPlaces(const Recording& recording, std::string_view text) {
  const std::vector<TextLine> lines = linesOf(text);
  for (const LineProblem& problem : recording.problems) checkPlace(problem, lines);
  for (const RecordedSighting& sighting : recording.sightings)
    require(sighting.line >= 1 && sighting.line <= lines.size(), "a sighting of a line that is not there");
  for (const std::string& sentence : recording.unused) require(!sentence.empty(), "a remark without words");
}

void importBytes(std::string_view bytes, const ImportOptions& options,
                 std::optional<std::size_t> turnedAtLine) {
  const Result<Import> import =
      importReadings({{.name = {}, .bytes = bytes, .turnedAtLine = turnedAtLine}}, options);
  if (!import) return require(!import.problem().what.empty(), "a file refused without words");
  const std::string text = *utf8Text(bytes);
  const std::vector<TextLine> lines = linesOf(text);
  for (const LineProblem& problem : import->problems) checkPlace(problem, lines);
  require(import->rows <= text.size(), "more rows than characters");  // elements of XML may share a line
  const std::string file = writeSession(import->session);
  const Result<Session> again = readSession(file);
  require(static_cast<bool>(again), "an imported session that cannot be read");
  require(writeSession(*again) == file, "an imported session that changes when it is read and written");
  for (const Problem& problem : examine(*again).problems)
    require(!problem.what.empty(), "a problem without words");
}

}  // namespace alidade::fuzz
