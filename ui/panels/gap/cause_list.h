#pragma once

#include <QStringList>
#include <QWidget>

#include "core/base/place.h"
#include "ui/jobs/gap.h"
#include "ui/jobs/remedies.h"

class QBoxLayout;
class QPushButton;
class QVBoxLayout;

namespace alidade::ui {

/// Every cause of a gap with its numbers and what can be done about it, and the effects the model holds
/// already. Changes nothing itself.
class CauseList : public QWidget {
  Q_OBJECT

 public:
  explicit CauseList(QWidget* parent = nullptr);

  void setGap(const Gap& gap);

 signals:
  /// Add these to the model's effects.
  void effectsWanted(const QStringList& ids);
  /// Take it out of the model's effects.
  void effectUnwanted(const QString& id);
  /// Set the session's vertical angle relation to `text`.
  void relationWanted(const QString& text);
  void placeActivated(const alidade::Place& place);
  void exclusionWanted(const alidade::Place& place);
  void rowsExclusionWanted(const alidade::ui::RowRange& rows);
  void noiseWanted(const alidade::ui::StatedNoise& noise);

 private:
  void addCause(const Gap& gap, const Cause& cause);
  void addEffectOfModel(const Gap& gap, const std::string& id);
  void addShape(const GapShape& shape);
  void addTitle(const QString& text, const QString& figure, const QString& toolTip = {});
  void addText(const QString& text, bool isQuiet = false);
  /// A button in the row of the cause at work.
  QPushButton* addButton(const QString& text, const QString& name);
  void addCatalogueButtons(const Gap& gap, const Cause& cause);
  void addAllCauses(const std::vector<Cause>& causes);
  void addGrossErrors(const Cause& cause);
  void addJump(const Gap& gap, const Cause& cause);
  void addRowsExclusion(const QString& text, const QString& name, const RowRange& rows);
  void addNoise(const Gap& gap, const Cause& cause);

  QVBoxLayout* m_layout;
  QBoxLayout* m_buttons = nullptr;  ///< of the cause at work; null until it has one
};

}  // namespace alidade::ui
