#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <functional>
#include <vector>

namespace alidade::ui {

/// One column of computed figures. Texts are made as cells are painted or the first 200 rows are measured, so
/// a long table costs no more than a short one.
struct DataColumn {
  QString title, toolTip;
  QString sample;  ///< a wide text: the column has its width if there is room; empty: that of the cells
  std::function<QString(int row)> text;
  Qt::Alignment alignment = Qt::AlignRight;  ///< left for words
};

class DataModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit DataModel(std::vector<DataColumn> columns, QObject* parent = nullptr);

  const std::vector<DataColumn>& columns() const { return m_columns; }
  void setRows(int rows);  ///< new figures; the selection stays if the number of rows is unchanged

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<DataColumn> m_columns;
  int m_rows = 0;
};

/// A read-only table of computed figures, selected by rows. Shows a reason when empty. Ctrl+C copies the
/// selected rows for a spreadsheet.
class DataTable : public QTableView {
  Q_OBJECT

 public:
  explicit DataTable(std::vector<DataColumn> columns, QWidget* parent = nullptr);

  void setRows(int rows);
  void setPlaceholder(const QString& text);
  /// Selects these rows (ascending) and scrolls to the first; an empty list clears the selection.
  void selectDataRows(const std::vector<int>& rows);
  void copy() const;

 signals:
  void rowActivated(int row);  ///< by click or Enter

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  int shownWidth(int column) const;
  /// Sets the width of each column: at least what its cells show, up to its sample. The room that is left
  /// goes to titles, then to wider cells, then to samples. Called again for another font or width, until the
  /// user sets a width.
  void fitCells();
  void widen(std::vector<int>& widths, const std::vector<int>& wanted) const;
  void fitAgain();

  DataModel m_model;
  QString m_placeholder;
  bool m_isFitting = false;  ///< the table itself is setting widths
  bool m_isFitted = true;    ///< false once the user sets a width
};

}  // namespace alidade::ui
