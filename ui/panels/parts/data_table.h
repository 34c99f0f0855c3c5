#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <functional>
#include <vector>

namespace alidade::ui {

/// One column of computed figures. Texts are made as cells are painted, so a long table costs no more than
/// the rows in view.
struct DataColumn {
  QString title, toolTip;
  QString sample;  ///< a wide text, for the width
  std::function<QString(int row)> text;
  Qt::Alignment alignment = Qt::AlignRight;  ///< words are better to the left
};

class DataModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit DataModel(std::vector<DataColumn> columns, QObject* parent = nullptr);

  const std::vector<DataColumn>& columns() const { return m_columns; }
  void setRows(int rows);  ///< the figures are new; with the same number of rows the selection stays

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<DataColumn> m_columns;
  int m_rows = 0;
};

/// A table of computed figures, selected by rows and never edited. Says why it is empty. Ctrl+C copies the
/// selected rows for a spreadsheet.
class DataTable : public QTableView {
  Q_OBJECT

 public:
  explicit DataTable(std::vector<DataColumn> columns, QWidget* parent = nullptr);

  void setRows(int rows) { m_model.setRows(rows); }
  void setPlaceholder(const QString& text);
  /// Selects these rows (ascending) and scrolls to the first; none: clears the selection.
  void selectDataRows(const std::vector<int>& rows);
  void copy() const;

 signals:
  void rowActivated(int row);  ///< clicked, or Enter

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  void fitCells();

  DataModel m_model;
  QString m_placeholder;
};

}  // namespace alidade::ui
