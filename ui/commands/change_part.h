#pragma once

#include <QString>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ui/commands/journalled_command.h"
#include "ui/document/journal_keeper.h"

namespace alidade::ui {

/// The change of a part, for the views and for the journal.
struct PartChange {
  SessionChange forViews;  ///< the change as sent to the views
  Place place;             ///< place in the journal entry
  std::string from, to;    ///< texts in the journal entry
};

/// The change of the part at `place`; views and journal receive the same place.
inline PartChange changeAt(const Place& place, std::string from, std::string to) {
  return {{.kind = SessionChange::Kind::Field, .place = place}, place, std::move(from), std::move(to)};
}

/// Replaces one part of the session: a text, a list or the instrument.
template <typename Part>
class ChangePart : public JournalledCommand {
 public:
  using PartOf = std::function<Part&(Session&)>;

  ChangePart(SessionDocument& document, const QString& text, PartOf partOf, Part after, PartChange change)
      : JournalledCommand(document, text),
        m_partOf(std::move(partOf)),
        m_other(std::move(after)),
        m_change(std::move(change)) {
    setEntries(journal().judge(m_change.place, m_change.from, m_change.to));
  }

 private:
  void apply() override {
    edit(m_change.forViews, [this](Session& session) { std::swap(m_partOf(session), m_other); });
  }
  std::vector<JournalEntry> allEntries() const override {
    return journal().asRecorded(m_change.place, m_change.from, m_change.to);
  }

  PartOf m_partOf;
  Part m_other;  ///< the new value before the edit, the old value after it
  PartChange m_change;
};

}  // namespace alidade::ui
