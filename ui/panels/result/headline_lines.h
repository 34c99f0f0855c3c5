#pragma once

#include <QList>
#include <QWidget>

#include "core/statement/headline.h"

class QLabel;

namespace alidade::ui {

/// The lines of small type below the result, each with a sign if it is a warning. The line about the gap is a
/// link to the page of the gap.
class HeadlineLines : public QWidget {
  Q_OBJECT

 public:
  explicit HeadlineLines(QWidget* parent = nullptr);

  void setLines(const std::vector<Headline::Line>& lines);

 signals:
  void gapActivated();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Row {
    QWidget* whole;
    QLabel* icon;
    QLabel* text;
  };

  Row& row(int index);

  std::vector<Headline::Line> m_lines;
  QList<Row> m_rows;
};

}  // namespace alidade::ui
