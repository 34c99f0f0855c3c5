#pragma once

#include <QString>
#include <cstddef>
#include <vector>

#include "core/base/place.h"
#include "core/session/session.h"
#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Adds a position of the axis without readings. A missing one at 0° goes first, since it is read first. One
/// at 180°, or a repeat, goes last, since repeats are in the order read.
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

/// True if the session has a position at `axisDeg`, 0 or 180. Invalid axis angles count for neither.
bool hasPosition(const Session& session, int axisDeg);

/// True if the position is missing, or if both exist: then the axis angle is repeated.
bool mayAddPosition(const Session& session, int axisDeg);

/// "Add position at 0°", "Measure 0° again": the text for adding it to this session.
QString addPositionText(const Session& session, int axisDeg);

/// Does nothing if it may not be added.
void addPosition(SessionDocument& document, int axisDeg);

/// The number of typed sightings of a position: rows with an angle, and pointing zeros.
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
  std::vector<JournalEntry> m_all;  ///< computed while the position exists
};

/// Does nothing if there is no such position.
void removePosition(SessionDocument& document, std::size_t index);

}  // namespace alidade::ui
