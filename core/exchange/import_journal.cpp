#include "core/exchange/import.h"

#include "core/base/problem.h"
#include "core/base/visible_text.h"

namespace alidade {

std::string linesText(const ImportedRows& rows) {
  constexpr std::size_t mostRuns = 20;
  std::string text;
  for (std::size_t i = 0; i < rows.lines.size(); ++i) {
    const auto& [first, last] = rows.lines[i];
    if (i == mostRuns) return text + " and others up to " + std::to_string(rows.lines.back().second);
    if (i > 0) text += ", ";
    text += std::to_string(first);
    if (last > first) text += "–" + std::to_string(last);
  }
  return text;
}

std::vector<JournalEntry> importEntries(const Import& import, const std::vector<ImportedFile>& files) {
  std::vector<JournalEntry> entries;
  for (const ImportedRows& rows : import.origins) {
    JournalEntry entry;
    entry.place = Place{.position = rows.position, .field = "readings"}.path();
    entry.axis = import.session.positions.at(rows.position).axisDeg;
    const bool isOne = rows.lines.size() == 1 && rows.lines[0].first == rows.lines[0].second;
    entry.to = "“" + wellFormed(files.at(rows.file).name) + (isOne ? "”, line " : "”, lines ") +
               linesText(rows) + ": " + std::to_string(rows.count) + (rows.count == 1 ? " row" : " rows") +
               " from row " + std::to_string(rows.firstRow + 1) + " on; SHA-256 " +
               files.at(rows.file).sha256;
    entry.why = journal_reasons::imported;
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace alidade
