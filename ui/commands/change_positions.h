#pragma once

#include <QString>
#include <cstddef>
#include <vector>

#include "core/base/problem.h"
#include "core/session/session.h"
#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Adds a position without readings. The first position at 0° is placed at the start, since it is measured
/// first. A position at 180° or a repeat is placed at the end, since repeats follow the order of measurement.
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

/// True if the session has a position at `axisDeg`, 0 or 180. Ignores invalid axis angles.
bool hasPosition(const Session& session, int axisDeg);

/// True if no position is at `axisDeg`, or if both 0° and 180° have a position, which allows a repeat.
bool mayAddPosition(const Session& session, int axisDeg);

/// The undo text for adding the position: "Add position at 0°", or "Measure 0° again" for a repeat.
QString addPositionText(const Session& session, int axisDeg);

/// Adds the position; does nothing unless `mayAddPosition`.
void addPosition(SessionDocument& document, int axisDeg);

/// The number of typed sightings of a position: rows and pointing zeros with a typed angle.
std::size_t typedSightings(const Position& position);

/// Removes a position with its pointing zero and all its readings.
class RemovePosition : public JournalledCommand {
 public:
  RemovePosition(SessionDocument& document, std::size_t index);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override { return m_all; }

  std::size_t m_index;
  Position m_position;
  std::vector<JournalEntry> m_all;  ///< result of `allEntries`, computed while the position exists
};

/// Does nothing if the session has no position `index`.
void removePosition(SessionDocument& document, std::size_t index);

}  // namespace alidade::ui
