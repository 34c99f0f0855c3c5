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

/// The typed rows of an instrument check: station, round, target, face, both circles, distance. One empty row
/// is always at the end.
class CheckRowsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit CheckRowsModel(QObject* parent = nullptr);

  static constexpr int columns = 7;
  /// The roles of the columns, without a row of names.
  static TableLayout layout();

  /// True if nothing is typed.
  bool isBlank() const { return m_rows.size() == 1; }
  /// True if no row can be evaluated.
  bool isEmpty() const { return countOfUse() == 0; }
  std::string csv() const;  ///< the rows to evaluate, without column names

  /// Pastes from this cell on, and adds missing rows. If the block names columns, its texts go to them, with
  /// degrees, minutes and seconds joined. The problem says why a block with column names is refused.
  std::optional<Problem> paste(const ReadingBlock& block, int row, int column);
  void clear(const QModelIndexList& cells);  ///< also removes rows that become empty

  ReadingBlock block() const;  ///< all rows except the empty one at the end
  /// Replaces all rows by `block`.
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
