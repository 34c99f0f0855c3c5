#include "core/session/journal.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/session/journal_check.h"
#include "core/session/session.h"
#include "core/session/session_file.h"

namespace alidade {

namespace {

bool isExplanation(const JournalEntry& entry) {
  return entry.why == journal_reasons::explained;
}

/// Is the entry at this index within the numbers, "12" or "12-14", that the explanation names?
bool explains(const JournalEntry& explanation, std::size_t index) {
  if (!isExplanation(explanation)) return false;
  const std::size_t hyphen = explanation.from.find('-');
  const Result<int> first = parseWhole(explanation.from.substr(0, hyphen));
  const Result<int> last =
      hyphen == std::string::npos ? first : parseWhole(explanation.from.substr(hyphen + 1));
  const auto number = static_cast<int>(index) + 1;
  return first && last && *first <= number && number <= *last;
}

}  // namespace

std::string journalHash(const std::string& before, const JournalEntry& entry) {
  auto list = nlohmann::ordered_json::array({before});
  for (const JournalField& field : journalFields)
    if (field.text != &JournalEntry::hash) list.push_back(entry.*field.text);
  return sha256(list.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

JournalEntry explainingEntry(const std::vector<JournalEntry>& journal, std::size_t first, std::size_t count,
                             const std::string& reason) {
  JournalEntry entry = journal.at(first);
  entry.at.clear();
  entry.by.clear();
  entry.from = std::to_string(first + 1);
  if (count > 1) entry.from += '-' + std::to_string(first + count);
  entry.to = reason;
  entry.why = journal_reasons::explained;
  entry.origin = {};
  return entry;
}

std::string explanationOf(const std::vector<JournalEntry>& journal, std::size_t index) {
  const auto later = journal.rend() - static_cast<std::ptrdiff_t>(index) - 1;
  const auto last = std::find_if(journal.rbegin(), later,
                                 [&](const JournalEntry& entry) { return explains(entry, index); });
  return last == later ? std::string() : last->to;
}

void enterInJournal(std::vector<JournalEntry>& journal, JournalEntry entry) {
  entry.hash = journalHash(journal.empty() ? std::string() : journal.back().hash, entry);
  journal.push_back(std::move(entry));
}

std::optional<std::size_t> firstBrokenEntry(const std::vector<JournalEntry>& journal) {
  std::string before;
  for (std::size_t i = 0; i < journal.size(); ++i) {
    if (journal[i].hash != journalHash(before, journal[i])) return i;
    before = journal[i].hash;
  }
  return {};
}

std::string fileWithoutJournal(const Session& session) {
  Session content = session;
  content.journal.clear();
  return writeSession(content);
}

std::string contentDigest(const Session& session) {
  return sha256(fileWithoutJournal(session));
}

std::size_t changedReadings(const Session& session) {
  std::size_t count = 0;
  for (const Position& position : session.positions)
    for (const Reading& row : position.readings) count += row.asRead.all().size();
  return count;
}

std::optional<Seal> sealOf(const std::vector<JournalEntry>& journal) {
  const auto last = std::find_if(journal.rbegin(), journal.rend(), [](const JournalEntry& entry) {
    return entry.why == journal_reasons::sealed;
  });
  if (last == journal.rend()) return {};
  const Result<int> revision = parseWhole(last->from);
  return Seal{.at = last->at,
              .by = last->by,
              .revision = revision ? *revision : 0,
              .digest = last->to,
              .entry = static_cast<std::size_t>(journal.rend() - last) - 1};
}

std::size_t changesSince(const Seal& seal, const std::vector<JournalEntry>& journal) {
  return static_cast<std::size_t>(std::count_if(journal.begin() + static_cast<std::ptrdiff_t>(seal.entry) + 1,
                                                journal.end(), std::not_fn(isExplanation)));
}

bool isAsSealed(const Session& session, const Seal& seal) {
  return contentDigest(session) == seal.digest;
}

JournalEntry sealingEntry(const Session& session, const std::string& by, const std::string& at) {
  const auto sealed = sealOf(session.journal);
  JournalEntry entry;
  entry.at = at;
  entry.by = by;
  entry.from = std::to_string(sealed ? sealed->revision + 1 : 0);
  const std::string text = fileWithoutJournal(session);
  entry.to = sha256(text);
  entry.why = journal_reasons::sealed;
  keepSealedContent(entry, text);
  return entry;
}

}  // namespace alidade
