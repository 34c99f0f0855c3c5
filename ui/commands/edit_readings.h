#pragma once

#include <QCoreApplication>
#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/session/sighting_order.h"
#include "ui/commands/reading_block.h"
#include "ui/document/reading_column.h"
#include "ui/document/readings_patch.h"

namespace alidade::ui {

class SessionDocument;

/// Edits the readings of one position; each edit is one undo step. Ignores rows beyond the readings unless
/// stated otherwise. An edit that changes nothing adds no undo step.
class ReadingsEditor {
  Q_DECLARE_TR_FUNCTIONS(ReadingsEditor)

 public:
  ReadingsEditor(SessionDocument& document, std::size_t position)
      : m_document(document), m_position(position) {}

  /// Sets the text of a cell. In the row after the last, appends a reading unless `typed` is empty: `added`,
  /// or else the `followingReading`. A typed or pasted angle without a unit gets the session's unit
  /// (`completedAngle`).
  void setCell(const ReadingCell& cell, const std::string& typed, const std::optional<Reading>& added = {});
  void insertBlank(std::size_t row);
  void remove(const std::vector<std::size_t>& rows);
  void setExcluded(const std::vector<std::size_t>& rows, bool excluded);
  /// Adds the reason for the exclusion of these rows to their notes; ignores rows in use.
  void addReason(const std::vector<std::size_t>& rows, const std::string& reason);
  /// The note of the row after `addReason`; empty if there is no such row.
  std::string noteWith(std::size_t row, const std::string& reason) const;
  void clear(const std::vector<ReadingCell>& cells, bool cut = false);

  /// Pastes `block` from `row` on, its columns into `columns` in the same order. Appends rows beyond the end,
  /// with point numbers if the block has no points. Returns the number of block columns without a target.
  std::size_t paste(const ReadingBlock& block, std::size_t row, const std::vector<ReadingColumn>& columns);

  /// The noun for a cell of this column in undo texts and messages; empty for the residuals.
  static QString noun(ReadingColumn column);

  /// Appends rows for further readings (`furtherRows`).
  void layOut(FurtherRows which);

 private:
  const std::vector<Reading>& readings() const;
  void enterTexts(const std::vector<NewText>& texts, const QString& undoText, const char* why);

  SessionDocument& m_document;
  std::size_t m_position;
};

/// Moves rows that were typed or imported at the wrong axis angle to the end of another position as
/// one undo step; keeps their order. Ignores missing rows.
void moveRows(SessionDocument& document, std::size_t from, const std::vector<std::size_t>& rows,
              std::size_t to);

/// Types the texts of `changes` into their cells as one undo step. Ignores missing cells; adds no undo step
/// if nothing changes.
void applyChanges(SessionDocument& document, const std::vector<CellChange>& changes, const QString& undoText);

}  // namespace alidade::ui
