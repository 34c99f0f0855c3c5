#pragma once

#include <QStringList>
#include <QWidget>

#include "core/base/place.h"
#include "core/evaluation/gap.h"
#include "core/evaluation/remedies.h"

class QBoxLayout;
class QPushButton;
class QVBoxLayout;

namespace alidade::ui {

/// Every cause of a gap with its numbers and possible actions, and the effects already in the model. Only
/// emits signals.
class CauseList : public QWidget {
  Q_OBJECT

 public:
  explicit CauseList(QWidget* parent = nullptr);

  void setGap(const Gap& gap);
  /// Has the gap a shape that no form tells better?
  static bool tellsShape(const Diagnosis& diagnosis) { return diagnosis.shape && diagnosis.forms.empty(); }

 signals:
  /// Asks to add these effects to the model.
  void effectsWanted(const QStringList& ids);
  /// Asks to remove the effect from the model.
  void effectUnwanted(const QString& id);
  /// Set the session's vertical angle relation to `text`.
  void relationWanted(const QString& text);
  void placeActivated(const alidade::Place& place);
  void exclusionWanted(const alidade::Place& place);
  void rowsExclusionWanted(const alidade::RowRange& rows);
  void noiseWanted(const alidade::StatedNoise& noise);

 private:
  void addCause(const Gap& gap, const Cause& cause);
  void addEffectOfModel(const Gap& gap, const std::string& id);
  void addShape(const GapShape& shape);
  void addTitle(const QString& text, const QString& figure, const QString& toolTip = {});
  void addText(const QString& text, bool isQuiet = false);
  /// Adds a button to the row of the cause being shown.
  QPushButton* addButton(const QString& text, const QString& name);
  void addCatalogueButtons(const Gap& gap, const Cause& cause);
  void addAllCauses(const std::vector<Cause>& causes);
  void addGrossErrors(const Cause& cause);
  void addJump(const Gap& gap, const Cause& cause);
  void addRowsExclusion(const QString& text, const QString& name, const RowRange& rows);
  void addNoise(const Gap& gap, const Cause& cause);

  QVBoxLayout* m_layout;
  QBoxLayout* m_buttons = nullptr;  ///< of the cause being shown; null until it has a button
};

}  // namespace alidade::ui
