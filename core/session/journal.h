#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/session/json_origin.h"

namespace alidade {

struct Session;

/// One change of an entry that stood already: what an original observation was, what it became and why. Kept
/// as text, as everything in a session; what does not apply is empty.
struct JournalEntry {
  std::string at = {};     ///< when, UTC: 2026-03-14T15:09:26Z
  std::string by = {};     ///< the operator, as the session had it then
  std::string place = {};  ///< in the session file, as it was then: "positions[0].readings[4].vertical"
  std::string axis = {};   ///< of the position: 0 or 180
  std::string point = {}, round = {}, face = {};  ///< of the row
  std::string from = {}, to = {};                 ///< as typed
  std::string why = {};                           ///< one of `journal_reasons`
  std::string hash = {};  ///< SHA-256 over the entry before and this one, in hexadecimal digits
  JsonOrigin origin = {};

  bool operator==(const JournalEntry&) const = default;
};

/// A text of an entry and its key in files.
struct JournalField {
  const char* key;
  std::string JournalEntry::*text;
};

/// In the order of the struct, the hash last.
inline constexpr JournalField journalFields[] = {
    {"at", &JournalEntry::at},         {"by", &JournalEntry::by},       {"place", &JournalEntry::place},
    {"axis_deg", &JournalEntry::axis}, {"point", &JournalEntry::point}, {"round", &JournalEntry::round},
    {"face", &JournalEntry::face},     {"from", &JournalEntry::from},   {"to", &JournalEntry::to},
    {"why", &JournalEntry::why},       {"hash", &JournalEntry::hash}};

/// Why an entry was changed.
namespace journal_reasons {
inline constexpr const char* retyped = "retyped";
inline constexpr const char* suggestion = "suggestion";  ///< of the search for misread readings, accepted
inline constexpr const char* cleared = "cleared";
inline constexpr const char* pasted = "pasted";
inline constexpr const char* excluded = "excluded";
inline constexpr const char* usedAgain = "used_again";
inline constexpr const char* deleted = "deleted";
inline constexpr const char* inserted = "inserted";
inline constexpr const char* moved = "moved";        ///< to another position
inline constexpr const char* imported = "imported";  ///< `to`: rows of which file, lines and SHA-256
inline constexpr const char* undone = "undone";      ///< after it had been saved
inline constexpr const char* sealed = "sealed";      ///< from: the revision, `to`: the digest of the content
}  // namespace journal_reasons

/// The hash of `entry` where `before` is that of the entry before it, empty for the first: SHA-256 over the
/// compact JSON list of `before` and the entry's texts in the order of `journalFields`.
std::string journalHash(const std::string& before, const JournalEntry& entry);

/// Adds the entry with its hash.
void enterInJournal(std::vector<JournalEntry>& journal, JournalEntry entry);

/// Index of the first entry whose hash is not that of what stands there: it, or one before it, was changed or
/// taken out. Absent where the chain is whole.
std::optional<std::size_t> firstBrokenEntry(const std::vector<JournalEntry>& journal);

/// SHA-256 of the session without its journal, as its file would be, in hexadecimal digits.
std::string contentDigest(const Session& session);

/// How many cells of readings are not as they were first entered.
std::size_t changedReadings(const Session& session);

/// What a session was sealed as.
struct Seal {
  std::string at, by;
  int revision = 0;       ///< 0 for the first seal
  std::string digest;     ///< of what was sealed
  std::size_t entry = 0;  ///< its index in the journal
};

/// The last seal; absent where the session was never sealed.
std::optional<Seal> sealOf(const std::vector<JournalEntry>& journal);

/// Is the content still what was sealed? Writes all of the session to see.
bool isAsSealed(const Session& session, const Seal& seal);

/// The entry that seals the present content as the next revision.
JournalEntry sealingEntry(const Session& session, const std::string& by, const std::string& at);

}  // namespace alidade
