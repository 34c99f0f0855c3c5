#include "core/exchange/recognise.h"

#include <algorithm>

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

Result<Recognised> recognise(std::string_view text) {
  const std::string_view beginning = beginningOf(text);
  TextLines lines(beginning);
  while (const auto next = lines.next()) {
    const TextLine& line = *next;
    const std::size_t first = line.text.find_first_not_of(" \t\x02");
    if (first == std::string_view::npos ||
        std::string_view("#@?%!").find(line.text[first]) != std::string_view::npos)
      continue;
    if (line.text[first] == '{')
      return Problem{Phrase::of("is no file of readings but JSON: open it as a session")};
    if (looksLikeSdr(line.text.substr(first)))
      return ofInstrument(FileFormat::Sdr, "Sokkia SDR",
                          Phrase::of("it begins with the heading of a Sokkia SDR file"), readSdr(beginning));
    if (looksLikeM5(line.text))
      return ofInstrument(FileFormat::M5, "Trimble M5", Phrase::of("its lines begin with For M5"),
                          readM5(beginning));
    if (looksLikeGsi(line.text))
      return ofInstrument(FileFormat::Gsi, "Leica GSI",
                          Phrase::of("its lines are made of words such as 21.102+17920860"),
                          readGsi(beginning));
    return recogniseTable(beginning);
  }
  return Problem{Phrase::of("holds no readings: choose a file of an instrument (GSI, M5, SDR) or a table")};
}

}  // namespace alidade
