#pragma once

#include <QLineEdit>
#include <vector>

class QTableView;

namespace alidade::ui {

/// A line over a table, below an excluded row, for the reason of the exclusion. Return accepts the typed
/// text, which may be empty; Escape gives no reason. Both return the focus to the table. While the line is
/// empty, Up, Down and Space close it and act on the table.
class ReasonLine : public QLineEdit {
  Q_OBJECT

 public:
  explicit ReasonLine(QTableView& table);

  /// Asks for the reason of these rows (ascending), unless the table is hidden.
  void ask(const std::vector<std::size_t>& rows);
  /// Closes the line. Emits `given` with the text typed so far, unless the text is empty.
  void finish();
  const std::vector<std::size_t>& rows() const { return m_rows; }  ///< asked about; empty while it is closed

 signals:
  void closed();  ///< emitted before `given`
  void given(const std::vector<std::size_t>& rows, const QString& reason);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void place();

  QTableView& m_table;
  std::vector<std::size_t> m_rows;
};

}  // namespace alidade::ui
