#pragma once

#include <QStringList>
#include <QVector>
#include <QWidget>

class QGridLayout;
class QLabel;

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
  };

  enum class Captions {
    OnOneLine,
    Wrapped,  ///< captions in two lines, if there is too little room next to the figures
  };

  explicit FigureGrid(QWidget* parent = nullptr, Captions captions = Captions::OnOneLine);

  void setRows(const QStringList& titles, const QVector<Row>& rows);

 private:
  QLabel* label(int row, int column);

  QGridLayout* m_grid;
  Captions m_captions;
};

/// The bold line above a grid.
QLabel* panelHeading(const QString& text);

/// A text of several lines that can be selected.
QLabel* wrappedLabel();

}  // namespace alidade::ui
