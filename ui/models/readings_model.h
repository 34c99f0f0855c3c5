#pragma once

#include <QAbstractTableModel>
#include <map>
#include <utility>
#include <vector>

#include "core/base/angle_text.h"
#include "ui/document/reading_column.h"
#include "ui/models/row_notes.h"

namespace alidade::ui {

class SessionDocument;
struct SessionChange;

/// The readings of one position as a table, with one extra empty row: typing in it appends a reading. Cells
/// show angles normalised and edit the typed text; every edit uses the undo stack. Residuals and problems
/// come from the newest evaluation and are never read back.
class ReadingsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Role {
    ProblemRole = Qt::UserRole + 1,  ///< QString: why the entry is unusable
    SuspectRole,                     ///< QString: why the reading looks misread or is unexpected
    IncompleteRole,                  ///< bool: an entry still to be made
    ExcludedRole,                    ///< bool: the row is excluded from the fit
    ChangedRole,                     ///< bool: the cell differs from its first text
    PendingRowRole,                  ///< bool: the empty row at the end
  };

  ReadingsModel(SessionDocument& document, std::size_t position, QObject* parent = nullptr);

  std::size_t position() const { return m_position; }
  int readingCount() const;  ///< rows without the empty one at the end
  Reading added() const;     ///< the reading that typing into the empty row at the end adds

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  struct OpenCell {
    int row = 0;
    ReadingColumn column = ReadingColumn::Horizontal;
  };
  /// The cell of the first missing circle reading in a row in use, else a cell of the empty row.
  OpenCell firstOpenCell() const;

  /// Signals a change of the residuals, or of all cells if problems, suspects or the form of angles changed.
  /// A view queries only visible cells.
  void setEvaluation(SharedEvaluation evaluation);

  /// Sets an objection to the cell's present text. A change of the cell, or of the number of rows before it,
  /// ends the objection.
  void setDoubt(std::size_t row, ReadingColumn column, const QString& doubt);

  /// True if any row has a text in the column other than the default, such as face 1.
  bool isUsed(ReadingColumn column) const;
  /// The same for `count` rows from `first` on.
  bool isUsed(ReadingColumn column, std::size_t first, std::size_t count) const;

  /// The text that copying takes from a cell of a reading: an entry as typed, a residual as shown.
  QString copiedText(int row, ReadingColumn column) const;

 signals:
  void excludedByClick(std::size_t row);

 private:
  const std::vector<Reading>& readings() const;
  const Reading& reading(int row) const { return readings()[static_cast<std::size_t>(row)]; }
  QString cellText(int row, ReadingColumn column) const;
  QString problem(int row, ReadingColumn column) const;
  QString suspicion(int row, ReadingColumn column) const;
  bool isIncomplete(int row, ReadingColumn column) const;
  QString toolTip(int row, ReadingColumn column) const;
  QString otherTip(int row, ReadingColumn column) const;
  /// Empty if the cell still has its first text.
  QString changeTip(int row, ReadingColumn column) const;
  QString residualTip(int row, ReadingColumn column) const;
  QString accessibleText(int row, ReadingColumn column) const;
  QString titleOf(ReadingColumn column) const;
  QVariant pendingRowData(ReadingColumn column, int role) const;
  QString columnTitle(ReadingColumn column) const;
  bool isMine(const SessionChange& change) const;
  int decimalsIn(ReadingColumn column) const;
  bool followAngles(const Session& session);
  void beginChange(const SessionChange& change);
  void endChange(const SessionChange& change);

  SessionDocument& m_document;
  std::size_t m_position;
  RowNotes m_notes;
  struct Doubt {
    std::string of;  ///< typed text that the objection is about
    QString text;
  };
  std::map<std::pair<std::size_t, ReadingColumn>, Doubt> m_doubts;
  CircleUnit m_unit = CircleUnit::Dms;      ///< unit of shown angles
  std::map<ReadingColumn, int> m_decimals;  ///< decimals of seconds, by column
};

}  // namespace alidade::ui
