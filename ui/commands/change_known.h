#pragma once

#include <optional>
#include <string>

#include "ui/commands/journalled_command.h"
#include "ui/document/known_entry.h"

namespace alidade::ui {

class SessionDocument;

/// Puts another entry in the place of one that says what is known, adds one at the end of its list, or takes
/// one away.
class ChangeKnown : public JournalledCommand {
 public:
  /// `member` is what was typed: there undo leads. `after` absent: the entry goes.
  ChangeKnown(SessionDocument& document, const KnownRef& ref, std::string_view member,
              std::optional<KnownSize> after, const QString& text);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override;

  Place m_place;
  std::optional<KnownSize> m_before, m_after;
};

/// What can be typed of an entry.
struct KnownCell {
  std::string KnownSize::*text;
  const char* member;  ///< its name in the session file
};
inline constexpr KnownCell knownCells[] = {
    {&KnownSize::value, "value"}, {&KnownSize::sigma, "sigma"}, {&KnownSize::from, "from"}};

/// Types `text` into one cell of a row of the session: the first text of a number makes its entry, in the
/// list it belongs in, and the last one taken away takes the entry away. What would change nothing leaves no
/// undo step.
void typeKnown(SessionDocument& document, const KnownRow& row, const KnownCell& cell,
               const std::string& text);

}  // namespace alidade::ui
