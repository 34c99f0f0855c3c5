#include "core/session/journal.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/session/journal_check.h"
#include "core/session/session.h"
#include "core/session/session_file.h"

namespace alidade {

std::string journalHash(const std::string& before, const JournalEntry& entry) {
  auto list = nlohmann::ordered_json::array({before});
  for (const JournalField& field : journalFields)
    if (field.text != &JournalEntry::hash) list.push_back(entry.*field.text);
  return sha256(list.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
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

std::string contentDigest(const Session& session) {
  Session content = session;
  content.journal.clear();
  return sha256(writeSession(content));
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

bool isAsSealed(const Session& session, const Seal& seal) {
  return contentDigest(session) == seal.digest;
}

JournalEntry sealingEntry(const Session& session, const std::string& by, const std::string& at) {
  const auto sealed = sealOf(session.journal);
  JournalEntry entry;
  entry.at = at;
  entry.by = by;
  entry.from = std::to_string(sealed ? sealed->revision + 1 : 0);
  Session content = session;
  content.journal.clear();
  const std::string text = writeSession(content);
  entry.to = sha256(text);
  entry.why = journal_reasons::sealed;
  keepSealedContent(entry, text);
  return entry;
}

}  // namespace alidade
