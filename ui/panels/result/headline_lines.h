#pragma once

#include <QList>
#include <QWidget>

#include "core/statement/headline.h"

class QLabel;

namespace alidade::ui {

/// The lines of small type below the result, each with a sign if it is a warning. That of the gap leads to
/// its page.
class HeadlineLines : public QWidget {
  Q_OBJECT

 public:
  explicit HeadlineLines(QWidget* parent = nullptr);

  /// While provisional, the line of the gap stays in grey as it was before the change.
  void setHeadline(const Headline& headline);
  /// Another session: nothing stays of the one before.
  void clear();

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
  void show(const std::vector<Headline::Line>& lines);

  std::vector<Headline::Line> m_lines;
  std::string m_gap;  ///< text of the last final line of the gap
  bool m_isProvisional = false;
  QList<Row> m_rows;
};

}  // namespace alidade::ui
