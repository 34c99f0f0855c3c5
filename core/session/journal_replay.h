#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/session/journal_check.h"

namespace alidade {

/// The content of a session file. The entries of its journal are reverted in it, the last one first.
class JournalReplay {
 public:
  using Json = nlohmann::ordered_json;

  /// The order in which the journal lists the rows of one deletion.
  enum class RowOrder {
    LastFirst,   ///< each entry is reverted alone
    FirstFirst,  ///< in journals of version 0; the entries of a deletion are reverted together
  };

  JournalReplay(const std::vector<JournalEntry>& journal, const std::string& content, RowOrder order);
  ~JournalReplay();

  /// Reverts an entry. Call it for the last entry first.
  void takeBack(std::size_t entry);
  /// Compares the content with the sealed one, and continues from the seal's copy if there is one.
  CheckedSeal::State atSeal(std::size_t entry);

  std::vector<JournalContradiction> takeContradictions() { return std::move(m_contradictions); }

 private:
  struct Path {
    std::optional<std::size_t> position, reading;
    std::string field;  ///< "pointing_zero.vertical"; empty: the row or position itself
  };

  struct EntryRow {
    std::optional<std::size_t> row;  ///< index of the row that the entry describes; absent: none, or several
    bool isTrue = false;             ///< nothing in the rows contradicts the entry
  };

  static std::optional<Path> pathOf(const std::string& place);
  void takeBackOne(std::size_t entry);
  std::size_t firstOfEdit(std::size_t last) const;
  void takeBackRow(const Path& path, std::size_t index);
  EntryRow rowOfEntry(const Json& rows, const Path& path, std::size_t index) const;
  EntryRow openRow(const Json& rows, const Path& path, std::size_t index) const;
  bool isLaterLeft(const std::string& field, const std::string& text, std::size_t index) const;
  void takeBackCell(const Path& path, std::size_t index);
  void takeBackText(const Path& path, const JournalEntry& entry);
  bool isAnywhere(const std::string& field, const std::string& text) const;
  Json* rowsOf(const Path& path);
  Json* rowOf(const Path& path, const JournalEntry& entry);
  void contradict(const std::string& place, const std::string& recorded, const std::string& held);
  std::vector<std::string> digestsOfAllForms() const;
  void compareWith(const Json& sealed);
  bool isDescribed(const std::string& place) const;
  bool isSealedBefore(std::size_t entry) const;

  const std::vector<JournalEntry>& m_journal;
  RowOrder m_order;
  std::unique_ptr<Json> m_content;
  std::vector<JournalContradiction> m_contradictions;
  std::size_t m_taken = static_cast<std::size_t>(-1);  ///< entries from this one on are reverted
  bool m_isOpaque = false;                             ///< an entry was met that cannot be reverted
  bool m_isExact = true;  ///< reverted content is as originally written, except for `m_absent`
  std::set<std::string> m_describedPlaces;  ///< places that entries describe in words instead of texts
  std::vector<std::string> m_absent;  ///< JSON pointers of empty or false members that may have been absent
  std::vector<Json> m_gone;           ///< rows that reverting removed, for entries that moved them
};

}  // namespace alidade
