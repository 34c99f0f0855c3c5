#include "core/session/journal_check.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "core/base/limits.h"
#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/session/journal_replay.h"
#include "core/session/row_fields.h"
#include "core/session/session.h"
#include "core/session/session_file.h"
#include "core/session/value_text.h"

namespace alidade {

namespace {

constexpr std::size_t mostRowsTakenBack = 20'000;
constexpr const char* contentKey = "content";

std::size_t rowCountOf(const Session& session) {
  std::size_t count = 0;
  for (const Position& position : session.positions) count += position.readings.size();
  return count;
}

/// The first entry earlier than its predecessor. Times have one format, so their texts sort by time.
std::optional<std::size_t> firstBackwards(const std::vector<JournalEntry>& journal) {
  for (std::size_t i = 1; i < journal.size(); ++i)
    if (!journal[i].at.empty() && !journal[i - 1].at.empty() && journal[i].at < journal[i - 1].at) return i;
  return {};
}

/// Does the entry summarise changes of many cells, whose rows keep their first texts?
bool countsCells(const JournalEntry& entry) {
  return entry.place.ends_with("].readings");
}

/// Adds a contradiction for each first text of a row whose change has no entry.
void addUnrecordedFirstTexts(const Session& session, std::vector<JournalContradiction>& contradictions) {
  if (std::ranges::any_of(session.journal, countsCells)) return;
  std::set<std::pair<std::string, std::string>> recorded;
  for (const JournalEntry& entry : session.journal) {
    const std::string field = entry.place.substr(entry.place.find_last_of('.') + 1);
    for (const std::string& text : {entry.from, entry.to})
      recorded.emplace(field, filedText(text, kindOfCell(field)));
  }
  for (std::size_t p = 0; p < session.positions.size(); ++p)
    for (std::size_t r = 0; r < session.positions[p].readings.size(); ++r)
      for (const auto& [field, first] : session.positions[p].readings[r].asRead.all())
        if (!recorded.contains({field, filedText(first, kindOfCell(field))}))
          contradictions.push_back(
              {Place{.position = p, .reading = r, .field = "as_read." + field}.path(), {}, first});
}

CheckedSeal sealAt(const std::vector<JournalEntry>& journal, std::size_t index) {
  const Result<int> revision = parseWhole(journal[index].from);
  return {{.at = journal[index].at,
           .by = journal[index].by,
           .revision = revision ? *revision : 0,
           .digest = journal[index].to,
           .entry = index},
          CheckedSeal::State::Unchecked};
}

/// Reverts the entries with this `order` of rows. `content` is `fileWithoutJournal(session)`.
JournalCheck takenBack(const Session& session, const std::string& content, JournalReplay::RowOrder order) {
  const std::vector<JournalEntry>& journal = session.journal;
  const bool isSmall = rowCountOf(session) <= mostRowsTakenBack;
  JournalReplay replay(journal, isSmall ? content : "{}", order);
  JournalCheck taken;
  for (std::size_t i = journal.size(); i-- > 0;) {
    if (journal[i].why == journal_reasons::explained) continue;
    if (journal[i].why != journal_reasons::sealed) {
      if (isSmall) replay.takeBack(i);
      continue;
    }
    CheckedSeal seal = sealAt(journal, i);
    if (isSmall)
      seal.state = replay.atSeal(i);
    else if (i + 1 == journal.size())
      seal.state =
          sha256(content) == seal.seal.digest ? CheckedSeal::State::Held : CheckedSeal::State::Changed;
    taken.seals.insert(taken.seals.begin(), seal);
  }
  taken.contradictions = replay.takeContradictions();
  return taken;
}

std::size_t faults(const JournalCheck& check) {
  return check.contradictions.size() + static_cast<std::size_t>(std::ranges::count(
                                           check.seals, CheckedSeal::State::Changed, &CheckedSeal::state));
}

/// Reverts the entries with the order of rows in journals since version 1, or with the order of version 0 if
/// it leaves fewer faults.
JournalCheck takenBack(const Session& session) {
  const std::string content = fileWithoutJournal(session);
  JournalCheck taken = takenBack(session, content, JournalReplay::RowOrder::LastFirst);
  if (taken.holds()) return taken;
  JournalCheck together = takenBack(session, content, JournalReplay::RowOrder::FirstFirst);
  return faults(together) < faults(taken) ? together : taken;
}

}  // namespace

bool JournalCheck::holds() const {
  return !broken && contradictions.empty() && std::ranges::none_of(seals, [](const CheckedSeal& seal) {
    return seal.state == CheckedSeal::State::Changed;
  });
}

JournalCheck checkJournal(const Session& session) {
  JournalCheck check = session.journal.empty() ? JournalCheck() : takenBack(session);
  check.broken = firstBrokenEntry(session.journal);
  check.backwards = firstBackwards(session.journal);
  addUnrecordedFirstTexts(session, check.contradictions);
  return check;
}

std::string sealedContent(const JournalEntry& seal) {
  const auto& object = seal.origin.object();
  const auto found = object.find(contentKey);
  if (found == object.end() || !found->is_string()) return {};
  std::string text = found->get<std::string>();
  return sha256(text) == seal.to && readSession(text) ? text : std::string();
}

void keepSealedContent(JournalEntry& seal, const std::string& content) {
  constexpr std::size_t most = limits::longestText;
  if (content.size() > most) return;
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (const JournalField& field : journalFields)
    object[field.key] = "-";  // fixes the order; the writer fills in the values
  object[contentKey] = content;
  seal.origin = JsonOrigin(object);
}

std::string rowText(const Reading& row) {
  std::string text;
  for (const RowField& field : rowFields) {
    if (!field.text || (row.*field.text).empty()) continue;
    if (!text.empty()) text += ", ";
    text += std::string(field.key) + ' ' + row.*field.text;
  }
  if (text.empty()) text = "empty row";
  if (row.excluded) text += ", excluded";
  return text;
}

}  // namespace alidade
