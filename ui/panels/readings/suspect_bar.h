#pragma once

#include <QFrame>
#include <optional>
#include <vector>

#include "core/evaluation/evaluation.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace alidade::ui {

/// Shows one probably misread reading at a time: what is wrong, the probable intention, and the possible
/// actions, each with one click or key. Hidden without suspects. Only emits signals.
class SuspectBar : public QFrame {
  Q_OBJECT

 public:
  explicit SuspectBar(QWidget* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation);
  /// The session changed: keeps the height of the bar, but offers no suspect until the new search ends.
  void setStale();
  /// The search was stopped: the suspects of this session are unknown.
  void setUnknown();
  /// Shows the suspect in this row of readings, if any.
  void showReading(std::size_t position, std::size_t row);

  const Suspect* current() const;  ///< null if there is none, or after a change of the session
  bool hasProposal() const;
  /// Emits `placeActivated` for the suspect shown; at the next call, shows the next suspect first.
  void goToNext();
  void useProposal(int index = 0);
  void exclude();

 signals:
  void placeActivated(const alidade::Place& place);
  void changesWanted(const std::vector<alidade::CellChange>& changes, const QString& undoText);
  void exclusionWanted(const alidade::Place& place);
  void suspectsChanged();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fitText();
  void createButtons();
  void showCurrent();
  void fillOthers(const Suspect& suspect);

  std::vector<Suspect> m_suspects;
  CircleUnit m_unit = CircleUnit::Dms;  ///< unit of the proposals
  std::size_t m_index = 0;
  bool m_isStale = true, m_isVisited = false;
  QLabel* m_text;
  QWidget* m_buttons;
  QPushButton* m_use;
  QToolButton* m_others;
  QPushButton* m_exclude;
  QLabel* m_count;
  QToolButton* m_next;
};

}  // namespace alidade::ui
