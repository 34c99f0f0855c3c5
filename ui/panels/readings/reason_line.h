#pragma once

#include <QLineEdit>
#include <vector>

class QTableView;

namespace alidade::ui {

/// A line over a table, below an excluded row, that takes the reason for the exclusion. Return gives what is
/// typed, which may be nothing, and Escape nothing; the keyboard is then the table's again. Keys that type no
/// reason, such as the arrows, pass an empty line by.
class ReasonLine : public QLineEdit {
  Q_OBJECT

 public:
  explicit ReasonLine(QTableView& table);

  /// Asks for the reason of these rows (ascending), unless the table is hidden.
  void ask(const std::vector<std::size_t>& rows);
  /// Gives what is typed so far.
  void finish();

 signals:
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
