#pragma once

#include <QStringList>
#include <QWidget>
#include <functional>
#include <optional>

#include "core/statement/statement.h"
#include "ui/panels/parts/data_table.h"

class QLabel;

namespace alidade::ui {

class FigureGrid;

/// Shows a statement: its title, its table with remarks as tool tips, its sentences and note. `setTicks`
/// gives tick boxes to rows with an id.
class StatementView : public QWidget {
  Q_OBJECT

 public:
  explicit StatementView(QWidget* parent = nullptr);

  /// Hidden without a statement, or with an empty one.
  void setStatement(const std::optional<Statement>& statement);
  /// Whether the row with this id starts ticked; absent: no tick box. `setTicks` acts on later statements.
  using TickOf = std::function<std::optional<bool>(const std::string& id)>;
  void setTicks(TickOf tickOf);
  /// The ids of the ticked rows, in order.
  QStringList ticked() const;

 signals:
  void ticksChanged();

 private:
  QLabel* m_title;
  FigureGrid* m_grid;
  TickOf m_tickOf;
  QLabel* m_sentences;
  QLabel* m_note;
};

/// Shows the table of a statement with many rows or columns. Rows can be selected and copied for a
/// spreadsheet; tool tips show the remarks on the columns.
class StatementTable : public DataTable {
  Q_OBJECT

 public:
  /// `columns` has the columns that every later statement has.
  explicit StatementTable(const Statement& columns, QWidget* parent = nullptr);

  void setStatement(Statement statement);

 private:
  Statement m_statement;
};

}  // namespace alidade::ui
