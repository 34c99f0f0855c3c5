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
  QString sample;  ///< the column is as wide as this text if there is room; empty: as wide as its cells
  std::function<QString(int row)> text;
  Qt::Alignment alignment = Qt::AlignRight;  ///< left for words
};

class DataModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit DataModel(std::vector<DataColumn> columns, QObject* parent = nullptr);

  const std::vector<DataColumn>& columns() const { return m_columns; }
  void setRows(int rows);  ///< announces new figures; keeps the selection if the number of rows is unchanged

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
  /// Sets the width of each column to that of its cells, at most to that of its sample, and at least to that
  /// of the longest word of its title: titles are wrapped. Free width then
  /// widens columns up to their titles, next their cells, last their samples. Called again after a change of
  /// font or width, until the user sets a width.
  void fitCells();
  void wrapTitles();
  void widen(std::vector<int>& widths, const std::vector<int>& wanted) const;
  void fitAgain();

  DataModel m_model;
  QString m_placeholder;
  bool m_isFitting = false;  ///< the table itself is setting widths
  bool m_isFitted = true;    ///< false once the user sets a width
};

}  // namespace alidade::ui
