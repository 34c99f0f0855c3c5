#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/session/json_origin.h"

namespace alidade {

struct Session;

/// One recorded change: the original observation, its new value and the reason. All of it is text, like
/// everything in a session; texts that do not apply are empty.
struct JournalEntry {
  std::string at = {};     ///< when, UTC: 2026-03-14T15:09:26Z
  std::string by = {};     ///< operator according to the session at that time
  std::string place = {};  ///< in the session file at that time: "positions[0].readings[4].vertical"
  std::string axis = {};   ///< axis of the position: 0 or 180
  std::string point = {}, round = {}, face = {};  ///< identify the row
  std::string from = {}, to = {};                 ///< old and new text as typed
  std::string why = {};                           ///< one of `journal_reasons`
  std::string hash = {};  ///< SHA-256 over the previous entry's hash and this entry, in hexadecimal digits
  JsonOrigin origin = {};

  bool operator==(const JournalEntry&) const = default;
};

/// A text of an entry and its key in files.
struct JournalField {
  const char* key;
  std::string JournalEntry::*text;
};

/// The fields in the order of the struct, the hash last.
inline constexpr JournalField journalFields[] = {
    {"at", &JournalEntry::at},         {"by", &JournalEntry::by},       {"place", &JournalEntry::place},
    {"axis_deg", &JournalEntry::axis}, {"point", &JournalEntry::point}, {"round", &JournalEntry::round},
    {"face", &JournalEntry::face},     {"from", &JournalEntry::from},   {"to", &JournalEntry::to},
    {"why", &JournalEntry::why},       {"hash", &JournalEntry::hash}};

/// The values of `JournalEntry::why`, the kinds of changes.
namespace journal_reasons {
inline constexpr const char* retyped = "retyped";
inline constexpr const char* suggestion = "suggestion";  ///< accepted proposal for a gross error
inline constexpr const char* cleared = "cleared";
inline constexpr const char* pasted = "pasted";
inline constexpr const char* excluded = "excluded";
inline constexpr const char* usedAgain = "used_again";
inline constexpr const char* deleted = "deleted";
inline constexpr const char* inserted = "inserted";
inline constexpr const char* moved = "moved";          ///< to another position
inline constexpr const char* imported = "imported";    ///< `to`: file, lines and SHA-256 of the rows
inline constexpr const char* undone = "undone";        ///< reverses a change that had been saved
inline constexpr const char* sealed = "sealed";        ///< `from`: revision, `to`: digest of the content
inline constexpr const char* explained = "explained";  ///< `to`: why the entries numbered `from` were made
}  // namespace journal_reasons

/// The hash of `entry`: SHA-256 over the compact JSON list of `before` and the entry's texts in the order of
/// `journalFields`. `before`: the hash of the previous entry; empty for the first entry.
std::string journalHash(const std::string& before, const JournalEntry& entry);

/// The entry that states why `count` entries from the index `first` on were made.
JournalEntry explainingEntry(const std::vector<JournalEntry>& journal, std::size_t first, std::size_t count,
                             const std::string& reason);

/// The reason last stated for the entry at `index`; empty if none was stated.
std::string explanationOf(const std::vector<JournalEntry>& journal, std::size_t index);

/// Appends the entry with its hash.
void enterInJournal(std::vector<JournalEntry>& journal, JournalEntry entry);

/// Index of the first entry with a wrong hash: this entry or an earlier one was changed or removed. Absent if
/// the chain is intact.
std::optional<std::size_t> firstBrokenEntry(const std::vector<JournalEntry>& journal);

/// The session without its journal, as written to a file.
std::string fileWithoutJournal(const Session& session);

/// SHA-256 of `fileWithoutJournal`, in hexadecimal digits.
std::string contentDigest(const Session& session);

/// The number of reading cells that differ from their first entry.
std::size_t changedReadings(const Session& session);

/// The state of a session when it was sealed.
struct Seal {
  std::string at, by;
  int revision = 0;       ///< 0 for the first seal
  std::string digest;     ///< SHA-256 of the sealed content
  std::size_t entry = 0;  ///< index of the seal's entry in the journal
};

/// The last seal; absent if the session was never sealed.
std::optional<Seal> sealOf(const std::vector<JournalEntry>& journal);

/// The number of changes after the seal; explanations do not count.
std::size_t changesSince(const Seal& seal, const std::vector<JournalEntry>& journal);

/// Is the content still the sealed one? Writes the whole session to compare.
bool isAsSealed(const Session& session, const Seal& seal);

/// The entry that seals the present content as the next revision.
JournalEntry sealingEntry(const Session& session, const std::string& by, const std::string& at);

}  // namespace alidade
