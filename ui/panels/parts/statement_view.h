#pragma once

#include <QWidget>
#include <optional>

#include "core/statement/statement.h"

class QLabel;

namespace alidade::ui {

class FigureGrid;

/// Shows a statement: its title, its table with remarks as tool tips, its note and sentences.
class StatementView : public QWidget {
  Q_OBJECT

 public:
  explicit StatementView(QWidget* parent = nullptr);

  /// Hidden without a statement.
  void setStatement(const std::optional<Statement>& statement);

 private:
  QLabel* m_title;
  FigureGrid* m_grid;
  QLabel* m_note;
};

}  // namespace alidade::ui
