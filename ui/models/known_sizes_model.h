#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ui/document/known_entry.h"

namespace alidade::ui {

class SessionDocument;
struct HalfTypedText;
struct KnownCell;
struct SessionChange;

/// The known sizes of the effects' parameters as an editable table (`knownRows`): value, standard uncertainty
/// and source. Every edit uses the undo stack.
class KnownSizesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum class Column { Number, Owner, Default, Value, Sigma, From };

  enum Role {
    ProblemRole = Qt::UserRole + 1,  ///< QString: why the entry is unusable
    IncompleteRole,                  ///< bool: the standard uncertainty is still to be typed
    QuietRole,                       ///< bool: shown pale, since the text was not typed
  };

  explicit KnownSizesModel(SessionDocument& document, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  /// True if a text in the table is unusable.
  bool hasProblem() const;
  /// The cell of an entry. If the entry no longer exists: the cell in the row that changed last, or invalid
  /// if no row has changed.
  QModelIndex cellOf(const KnownPlace& place) const;
  /// The cell of the first parameter of a catalogued effect; invalid if there is none.
  QModelIndex cellOf(const std::string& effect) const;
  /// The unfinished entry `text`, typed into a cell.
  HalfTypedText halfTyped(const QModelIndex& cell, const QString& text) const;

 private:
  const KnownRow& row(const QModelIndex& index) const {
    return m_rows[static_cast<std::size_t>(index.row())];
  }
  const std::string& typed(const KnownRow& row, const KnownCell& cell) const;
  QString text(const QModelIndex& index) const;
  QString cellText(const KnownRow& row, Column column) const;
  QString problem(const KnownRow& row, Column column) const;
  QString about(const QModelIndex& index) const;
  void follow(const SessionChange& change);

  SessionDocument& m_document;
  std::vector<KnownRow> m_rows;
  int m_lastChanged = -1;  ///< row number; −1: none
};

}  // namespace alidade::ui
