#pragma once

#include <QFrame>
#include <optional>
#include <vector>

#include "ui/jobs/evaluation.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace alidade::ui {

/// One reading that looks misread at a time: what is wrong with it, what was probably meant, and what can be
/// done, each with one click or key. Gone where nothing looks misread. Changes nothing itself.
class SuspectBar : public QFrame {
  Q_OBJECT

 public:
  explicit SuspectBar(QWidget* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation);
  /// The session changed: until its suspects are found nothing is shown or used; the bar keeps its place.
  void setStale();
  /// The search was stopped: nothing is known of this session.
  void setUnknown();
  /// Shows the suspect of this row of readings, where it has one.
  void showReading(std::size_t position, std::size_t row);

  const Suspect* current() const;  ///< null where there is none, or the session has changed since
  bool hasProposal() const;
  /// Leads to the suspect shown; asked again, to the next.
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
  CircleUnit m_unit = CircleUnit::Dms;  ///< in which proposals are shown
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
