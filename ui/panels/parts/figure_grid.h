#pragma once

#include <QLabel>
#include <QStringList>
#include <QVector>
#include <QWidget>
#include <optional>

class QCheckBox;
class QGridLayout;

namespace alidade::ui {

/// A small grid of named figures: a caption at the left of each row, figures flush right under the column
/// titles. The labels are reused for new rows, so new figures change only texts.
class FigureGrid : public QWidget {
  Q_OBJECT

 public:
  struct Row {
    QString caption;
    QStringList figures;
    QString toolTip = {};
    QStringList below = {};  ///< texts below the row, over the whole width
    bool isPart = false;     ///< a detail of the row above: indented
    bool isBold = false;
    std::optional<double> bar = {};  ///< 0…1, behind the figure of the column `barColumn`
    QString tick = {};               ///< id of a row that can be ticked
    bool isTicked = false;           ///< initial state of the tick box
  };

  enum class Captions {
    OnOneLine,
    Wrapped,  ///< captions in two lines, if there is too little room next to the figures
  };

  explicit FigureGrid(QWidget* parent = nullptr, Captions captions = Captions::OnOneLine);

  /// `barColumn`: the column whose figures are flush left, with bars behind them; −1: none.
  void setRows(const QStringList& titles, const QVector<Row>& rows, int barColumn = -1);
  /// The ids of the ticked rows, in order.
  QStringList ticked() const;

 signals:
  void ticksChanged();

 private:
  class Figure;

  Figure* label(int row, int column);
  void showTicks(const QVector<Row>& rows);

  QGridLayout* m_grid;
  Captions m_captions;
  QVector<QCheckBox*> m_ticks;  ///< named by the ids of their rows
};

/// The bold line above a grid.
QLabel* panelHeading(const QString& text);

/// A text of several lines that can be selected.
QLabel* wrappedLabel();

}  // namespace alidade::ui
