#pragma once

#include <QWidget>

#include "core/evaluation/gap.h"
#include "ui/settings/theme.h"

class QLabel;

namespace alidade::ui {

/// A verdict, such as that of a diagnosis: its sign, its headline in the matching colour, and its sentences.
class GapHeadline : public QWidget {
  Q_OBJECT

 public:
  explicit GapHeadline(QWidget* parent = nullptr);

  /// Shows the verdict, or why there is none.
  void setGap(const Gap& gap);
  /// Shows the texts, with the sign and colour of `state`.
  void setText(const QString& headline, const QString& sentence, State state = State::Quiet);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void setState(State state);
  void color();

  State m_state = State::Quiet;
  QLabel *m_icon, *m_headline, *m_sentence;
};

}  // namespace alidade::ui
