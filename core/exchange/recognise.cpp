#include "core/exchange/recognise.h"

#include <algorithm>

#include "core/base/phrase.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

constexpr std::size_t mostBytesLookedAt = std::size_t{256} << 10;

/// The first whole lines of the text.
std::string_view beginningOf(std::string_view text) {
  if (text.size() <= mostBytesLookedAt) return text;
  text = text.substr(0, mostBytesLookedAt);
  return text.substr(0, std::min(text.find_last_of("\r\n"), text.size() - 1) + 1);
}

Recognised ofInstrument(const FileFormat& format, const Recording& beginning) {
  Recognised found;
  found.format = &format;
  found.name = format.name;
  found.reasons.push_back(Phrase::of(format.reason));
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
  if (!isTable()) return name;
  std::string text = "table " + std::to_string(static_cast<int>(table.separator));
  if (titles.empty()) return text + " " + std::to_string(table.columns.size());
  for (const std::string& title : titles) text += "|" + title;
  return text;
}

Result<Recognised> recognise(std::string_view text) {
  const std::string_view beginning = beginningOf(text);
  if (contentLines(beginning, 1).empty())
    return Problem{Phrase::of("holds no readings: choose a file of an instrument (GSI, M5, SDR) or a table")};
  const FileFormat* format = formatOfText(beginning);
  if (!format) return recogniseTable(beginning);
  if (!format->read) return notRead(*format);
  return ofInstrument(*format, format->read(beginning, {}));
}

}  // namespace alidade
