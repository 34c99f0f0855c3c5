#include "core/exchange/recognise.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/phrase.h"
#include "core/exchange/gsi_reader.h"
#include "core/exchange/gsi_word.h"
#include "core/exchange/m5_reader.h"
#include "core/exchange/recognise_table.h"
#include "core/exchange/sdr_reader.h"
#include "core/exchange/text_lines.h"

namespace alidade {

namespace {

constexpr std::size_t mostBytesLookedAt = std::size_t{256} << 10;

/// Whole lines of it.
std::string_view beginningOf(std::string_view text) {
  if (text.size() <= mostBytesLookedAt) return text;
  text = text.substr(0, mostBytesLookedAt);
  return text.substr(0, std::min(text.find_last_of("\r\n"), text.size() - 1) + 1);
}

Recognised ofInstrument(FileFormat format, const char* name, const std::string& why,
                        const Recording& beginning) {
  Recognised found;
  found.format = format;
  found.name = name;
  found.reasons.push_back(why);
  found.saysAxis = std::any_of(beginning.sightings.begin(), beginning.sightings.end(),
                               [](const RecordedSighting& sighting) { return !sighting.axis.text.empty(); });
  return found;
}

}  // namespace

bool hasCircles(const TableLayout& layout) {
  return std::all_of(rowFields.begin(), rowFields.end(), [&layout](const RowField& field) {
    return !field.remedy ||
           std::find(layout.columns.begin(), layout.columns.end(), field.key) != layout.columns.end();
  });
}

std::string Recognised::signature() const {
  if (format != FileFormat::Table) return name;
  std::string text = "table " + std::to_string(static_cast<int>(table.separator));
  if (titles.empty()) return text + " " + std::to_string(table.columns.size());
  for (const std::string& title : titles) text += "|" + title;
  return text;
}

namespace {

/// A number in a table may begin as a word does; a line of a listing may have something before its words.
bool isSoundGsi(std::string_view line) {
  constexpr int horizontal = 21, vertical = 22;
  const auto block = GsiBlocks({.number = 0, .text = line}).next();
  if (!block || block->words.empty()) return false;
  const auto isCircle = [](const GsiWord& word) {
    return word.isWhole && (word.index == horizontal || word.index == vertical);
  };
  return block->torn.empty() ? block->words.front().isWhole : std::ranges::any_of(block->words, isCircle);
}

/// As an instrument's file, where the line begins one; `text` is the file's beginning.
std::optional<Recognised> recogniseInstrument(std::string_view line, std::string_view text) {
  if (looksLikeSdr(line))
    return ofInstrument(FileFormat::Sdr, "Sokkia SDR",
                        Phrase::of("it begins with the heading of a Sokkia SDR file"), readSdr(text));
  if (looksLikeM5(line))
    return ofInstrument(FileFormat::M5, "Trimble M5", Phrase::of("its lines begin with For M5"),
                        readM5(text));
  if (looksLikeGsi(line) || isSoundGsi(line))
    return ofInstrument(FileFormat::Gsi, "Leica GSI",
                        Phrase::of("its lines are made of words such as 21.102+17920860"), readGsi(text));
  return std::nullopt;
}

}  // namespace

Result<Recognised> recognise(std::string_view text) {
  constexpr std::size_t mostHeadings = 20;  // lines that somebody wrote above those of an instrument
  const std::string_view beginning = beginningOf(text);
  TextLines lines(beginning);
  std::size_t headings = 0;
  while (const auto next = lines.next()) {
    const std::string_view line = next->text;
    const std::size_t first = line.find_first_not_of(" \t\x02");
    if (first == std::string_view::npos ||
        std::string_view("#@?%!").find(line[first]) != std::string_view::npos)
      continue;
    if (line[first] == '{' && headings == 0)
      return Problem{Phrase::of("is no file of readings but JSON: open it as a session")};
    if (headings == 0 || !looksLikeGsi(line) || isSoundGsi(line))
      if (auto found = recogniseInstrument(line.substr(first), beginning)) return *std::move(found);
    if (++headings == mostHeadings) break;
  }
  if (headings > 0) return recogniseTable(beginning);
  return Problem{Phrase::of("holds no readings: choose a file of an instrument (GSI, M5, SDR) or a table")};
}

}  // namespace alidade
