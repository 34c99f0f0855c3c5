#pragma once

#include <QString>
#include <cstddef>

#include "core/base/place.h"
#include "core/session/session.h"
#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Adds a position of the axis without readings. A missing one at 0° goes first, since it is taken first; one
/// at 180°, or one measured again, goes last: positions measured again stand in the order taken.
class AddPosition : public JournalledCommand {
 public:
  /// `axisDeg`: 0 or 180.
  AddPosition(SessionDocument& document, int axisDeg);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override;
  Place place() const;

  std::size_t m_index;
  Position m_position;
};

/// Has the session a position at `axisDeg`, 0 or 180? One whose axis cannot be understood is at neither.
bool hasPosition(const Session& session, int axisDeg);

/// Where the position is missing, or where both are there: then the axis is measured again.
bool mayAddPosition(const Session& session, int axisDeg);

/// "Add position at 0°", "Measure 0° again": what adding it to this session is called.
QString addPositionText(const Session& session, int axisDeg);

/// Does nothing where it may not be added.
void addPosition(SessionDocument& document, int axisDeg);

}  // namespace alidade::ui
