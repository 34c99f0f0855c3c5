#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ui/document/known_entry.h"

namespace alidade::ui {

class SessionDocument;
struct HalfTypedText;
struct KnownCell;
struct SessionChange;

/// What is known of every number of the catalogue as a table (`knownRows`), to be typed into: value, standard
/// uncertainty and where it is known from. Every edit goes through the undo stack.
class KnownSizesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum class Column { Number, Owner, Default, Value, Sigma, From };

  enum Role {
    ProblemRole = Qt::UserRole + 1,  ///< QString: why the entry cannot be used
    IncompleteRole,                  ///< bool: an entry still to be made
    QuietRole,                       ///< bool: nothing of the session
  };

  explicit KnownSizesModel(SessionDocument& document, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  /// Is a text in it that cannot be used?
  bool hasProblem() const;
  /// Of the entry at a place of the session; where it is gone, of what changed last. Invalid where nothing
  /// did.
  QModelIndex cellOf(const KnownPlace& place) const;
  /// Of an effect of the catalogue, its first number; invalid where it has none.
  QModelIndex cellOf(const std::string& effect) const;
  /// `text` typed into a cell.
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
  int m_lastChanged = -1;  ///< row
};

}  // namespace alidade::ui
