#pragma once

#include <cstddef>
#include <vector>

#include "core/session/session.h"
#include "ui/document/journal_entries.h"
#include "ui/document/open_entries.h"

namespace alidade::ui {

/// Writes the journal of the session at work: which edits are changes of entries that stood, and what undo
/// makes of them. What was never saved may be taken out again without a trace; what a file holds is answered
/// by a further entry.
class JournalKeeper {
 public:
  explicit JournalKeeper(Session& session) : m_session(session) {}

  /// What the keeper knows of a session beside what is in it.
  struct State {
    OpenEntries open = {};
    std::size_t filed = 0;  ///< entries of its journal that a file holds
    int filedIndex = 0;     ///< commands on the undo stack that the file holds
  };
  static State stateOf(const Session& session, bool isNew);

  /// Another session is at work; `isNew`: one that is in no file and still being filled in.
  void restart(bool isNew);
  /// Another session is at work, of which that is known; becomes what is known of the one before.
  void exchange(State& state);
  /// The session, all commands up to `undoIndex` done, is in a file now.
  void setFiled(int undoIndex);
  /// The commands from `undoIndex` on are about to be dropped from the undo stack.
  void dropFrom(int undoIndex);
  /// Does the file hold what the command at `undoIndex` did?
  bool isFiled(int undoIndex) const { return undoIndex < m_state.filedIndex; }

  /// What an edit, about to be made, is to the journal. First texts that it would overwrite are kept in
  /// `patch`.
  std::vector<JournalEntry> judge(std::size_t position, ReadingsPatch& patch, const char* why);
  std::vector<JournalEntry> judge(const Place& field, const std::string& from, const std::string& to);
  /// Likewise, had `from` stood.
  std::vector<JournalEntry> asStanding(const Place& field, const std::string& from,
                                       const std::string& to) const;

  /// How many entries are as they were when this was last asked.
  std::size_t takeKept();

  /// With time and operator.
  void enter(std::vector<JournalEntry> entries);
  /// Takes the last `count` out and answers with them, where they are in no file; else enters their reverse.
  std::vector<JournalEntry> takeBack(std::size_t count);

 private:
  bool isSealed() const { return sealOf(m_session.journal).has_value(); }

  Session& m_session;
  State m_state;
  std::size_t m_kept = 0;
};

}  // namespace alidade::ui
