#pragma once

#include <cstddef>
#include <vector>

#include "core/session/session.h"
#include "ui/document/journal_entries.h"
#include "ui/document/open_entries.h"

namespace alidade::ui {

/// Writes the journal of the current session. An edit of recorded entries adds journal entries. Undo removes
/// journal entries that are not saved in a file yet; for saved journal entries, undo adds reverse entries.
class JournalKeeper {
 public:
  explicit JournalKeeper(Session& session) : m_session(session) {}

  /// The keeper's data about a session, in addition to the session itself.
  struct State {
    OpenEntries open = {};
    std::size_t filed = 0;  ///< number of journal entries saved in a file
    int filedIndex = 0;     ///< number of executed commands on the undo stack when the file was saved
  };
  static State stateOf(const Session& session, bool isNew);

  /// Called after another session became current. `isNew`: that session is unsaved and still being filled in.
  void restart(bool isNew);
  /// Called after the session with the state `state` became current; `state` receives the previous state.
  void exchange(State& state);
  /// Records that the session, with all commands up to `undoIndex`, was saved in a file.
  void setFiled(int undoIndex);
  /// Called before the commands from `undoIndex` on are dropped from the undo stack.
  void dropFrom(int undoIndex);
  /// True if the file includes the command at `undoIndex`.
  bool isFiled(int undoIndex) const { return undoIndex < m_state.filedIndex; }

  /// Returns the journal entries of an edit about to be made. Marks in `patch` the first texts to be kept.
  std::vector<JournalEntry> judge(std::size_t position, ReadingsPatch& patch, const char* why);
  std::vector<JournalEntry> judge(const Place& field, const std::string& from, const std::string& to);
  /// The journal entries of an edit of this field if `from` had been recorded.
  std::vector<JournalEntry> asRecorded(const Place& field, const std::string& from,
                                       const std::string& to) const;

  /// Adds the entries to the journal; sets time and operator where they are empty.
  void enter(std::vector<JournalEntry> entries);
  /// Removes and returns the last `count` entries if no file has them; else adds their reverse.
  std::vector<JournalEntry> takeBack(std::size_t count);

 private:
  bool isSealed() const { return sealOf(m_session.journal).has_value(); }

  Session& m_session;
  State m_state;
};

}  // namespace alidade::ui
