#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "core/base/problem.h"
#include "core/exchange/table_layout.h"
#include "ui/commands/reading_block.h"

namespace alidade::ui {

/// Rows of an instrument check as they are typed: station, round, target, face, both circles, distance. There
/// is always an empty row to go on in.
class CheckRowsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit CheckRowsModel(QObject* parent = nullptr);

  static constexpr int columns = 7;
  /// What they hold, in turn, and that no row names them.
  static TableLayout layout();

  /// Is nothing typed?
  bool isBlank() const { return m_rows.size() == 1; }
  /// Is there no row to be evaluated?
  bool isEmpty() const { return countOfUse() == 0; }
  std::string csv() const;  ///< line by line the rows, without one at the end that is still being typed

  /// Into the cells from this one on; further rows are added. A block whose first rows name columns goes
  /// where the names say, degrees, minutes and seconds in columns of their own joined; the problem says why
  /// such a block cannot be taken, and nothing of it is.
  std::optional<Problem> paste(const ReadingBlock& block, int row, int column);
  void clear(const QModelIndexList& cells);  ///< rows that are empty then go

  ReadingBlock block() const;  ///< all rows but the empty one at the end
  /// Puts `block` in place of all rows.
  void restore(const ReadingBlock& block);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 signals:
  void edited();

 private:
  void put(int row, int column, const QString& text);
  void putNamed(const JoinedTable& table, int row);
  void tidy();
  std::size_t countOfUse() const;

  std::vector<QStringList> m_rows;
};

}  // namespace alidade::ui
