#pragma once

#include <optional>
#include <string>

#include "ui/commands/journalled_command.h"
#include "ui/document/known_entry.h"

namespace alidade::ui {

class SessionDocument;

/// Replaces an entry of a known size, appends one to its list, or removes one.
class ChangeKnown : public JournalledCommand {
 public:
  /// `member`: the typed member, to which undo leads. `after` absent: removes the entry.
  ChangeKnown(SessionDocument& document, const KnownRef& ref, std::string_view member,
              std::optional<KnownSize> after, const QString& text);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override;

  Place m_place;
  std::optional<KnownSize> m_before, m_after;
};

/// An editable member of an entry.
struct KnownCell {
  std::string KnownSize::*text;
  const char* member;  ///< its name in the session file
};
inline constexpr KnownCell knownCells[] = {
    {&KnownSize::value, "value"}, {&KnownSize::sigma, "sigma"}, {&KnownSize::from, "from"}};

/// Types `text` into one cell of a row of the session. The first text of a number creates its entry in the
/// proper list; removing the last text removes the entry. Without a change there is no undo step.
void typeKnown(SessionDocument& document, const KnownRow& row, const KnownCell& cell,
               const std::string& text);

}  // namespace alidade::ui
