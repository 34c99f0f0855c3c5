#pragma once

#include <QStringList>
#include <QWidget>

#include "core/base/problem.h"
#include "core/evaluation/gap.h"
#include "core/evaluation/remedies.h"

class QBoxLayout;
class QPushButton;
class QVBoxLayout;

namespace alidade::ui {

/// Remedies for causes that are not effects of the model (misread values, a jump, larger noise), and for the
/// vertical angle relation, which is better set than estimated. Buttons only emit signals. Hidden if empty.
class RemedyList : public QWidget {
  Q_OBJECT

 public:
  explicit RemedyList(QWidget* parent = nullptr);

  void setGap(const Gap& gap);

 signals:
  /// Asks to set the session's vertical angle relation to `text`.
  void relationWanted(const QString& text);
  void placeActivated(const alidade::Place& place);
  void exclusionWanted(const alidade::Place& place);
  void rowsExclusionWanted(const alidade::RowRange& rows);
  void noiseWanted(const alidade::StatedNoise& noise);

 private:
  void addText(const QString& text);
  /// Adds a button to the current row of buttons; if `m_buttons` is null, starts a row.
  QPushButton* addButton(const QString& text, const QString& name);
  void addRelation(const Gap& gap);
  void addGrossErrors(const Cause& cause);
  void addJump(const Gap& gap, const Cause& cause);
  void addRowsExclusion(const QString& text, const QString& name, const RowRange& rows);
  void addNoise(const Gap& gap, const Cause& cause);

  QVBoxLayout* m_layout;
  QBoxLayout* m_buttons = nullptr;  ///< buttons of the current cause; null before its first button
};

}  // namespace alidade::ui
