#pragma once

#include <cstddef>
#include <vector>

#include "core/session/session.h"
#include "ui/document/journal_entries.h"
#include "ui/document/open_entries.h"

namespace alidade::ui {

/// Writes the journal of the current session: which edits change recorded entries, and the effect of undo on
/// them. Undo removes an unsaved entry without a trace; an entry in a file gets a reverse entry.
class JournalKeeper {
 public:
  explicit JournalKeeper(Session& session) : m_session(session) {}

  /// The keeper's data about a session, in addition to the session itself.
  struct State {
    OpenEntries open = {};
    std::size_t filed = 0;  ///< number of journal entries saved in a file
    int filedIndex = 0;     ///< number of commands on the undo stack saved in the file
  };
  static State stateOf(const Session& session, bool isNew);

  /// Starts another session; `isNew`: unsaved and still being filled in.
  void restart(bool isNew);
  /// Starts another session with this state; `state` receives that of the previous one.
  void exchange(State& state);
  /// The session, with all commands up to `undoIndex`, is saved in a file.
  void setFiled(int undoIndex);
  /// The commands from `undoIndex` on are about to be dropped from the undo stack.
  void dropFrom(int undoIndex);
  /// True if the file includes the command at `undoIndex`.
  bool isFiled(int undoIndex) const { return undoIndex < m_state.filedIndex; }

  /// The journal entries of an edit about to be made. `patch` keeps the first texts that it would overwrite.
  std::vector<JournalEntry> judge(std::size_t position, ReadingsPatch& patch, const char* why);
  std::vector<JournalEntry> judge(const Place& field, const std::string& from, const std::string& to);
  /// The journal entries of an edit of this field if `from` had been recorded.
  std::vector<JournalEntry> asRecorded(const Place& field, const std::string& from,
                                       const std::string& to) const;

  /// Adds the entries with time and operator.
  void enter(std::vector<JournalEntry> entries);
  /// Removes and returns the last `count` entries if no file has them; else adds their reverse.
  std::vector<JournalEntry> takeBack(std::size_t count);

 private:
  bool isSealed() const { return sealOf(m_session.journal).has_value(); }

  Session& m_session;
  State m_state;
};

}  // namespace alidade::ui
