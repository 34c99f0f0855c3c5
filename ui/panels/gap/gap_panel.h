#pragma once

#include "core/evaluation/remedies.h"
#include "ui/jobs/gap_job.h"
#include "ui/panels/parts/scroll_page.h"

class QBoxLayout;
class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace alidade::ui {

class ClosureBars;
class DataTable;
class FormList;
class GapHeadline;
class GapMap;
class LeftoverStrips;
class RemedyList;
class StatementView;

/// The gap between model and readings: verdict, causes and forms with actions, how far the gap shrinks, where
/// it lies, what to measure next, undetectable effects and all candidates. Actions only emit signals.
class GapPanel : public ScrollPage {
  Q_OBJECT

 public:
  explicit GapPanel(QWidget* parent = nullptr);

  void setGap(const SharedGap& gap);
  /// The session changed: the old contents stay, with actions disabled until the new diagnosis.
  void setStale();
  /// Empties the page for another session, which is not diagnosed yet.
  void clear();

  QSize minimumSizeHint() const override { return {300, 160}; }

 signals:
  void watched(bool isWatched);  ///< whether the page is in front
  void effectsWanted(const QStringList& ids);
  void effectUnwanted(const QString& id);
  void relationWanted(const QString& text);
  void placeActivated(const alidade::Place& place);
  void exclusionWanted(const alidade::Place& place);
  void rowsExclusionWanted(const alidade::RowRange& rows);
  void formWanted(const alidade::FoundForm& form);  ///< asks to keep the form as an effect
  void noiseWanted(const alidade::StatedNoise& noise);
  void referenceWanted(bool wanted);  ///< asks to weigh the causes with the reference, or without

 protected:
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* createCauses();
  QWidget* createCandidates();
  QPushButton* addAction(const QString& text, const QString& name, const QString& toolTip);
  void arrange();
  void showVerdict();
  void showActions();
  void showClosures();
  void showReference();
  void showCandidate();
  void addCandidate();
  /// The ids of the ticked causes: those in the model if `isOfModel`, else those not in the model.
  QStringList ticked(bool isOfModel) const;
  /// The ticked causes and their look-alikes, without those already in the model.
  QStringList tickedWithLookAlikes() const;
  /// The candidate in `row`; null if there is none.
  const Candidate* candidate(int row) const;
  bool isInModel(const std::string& id) const;

  SharedGap m_gap;
  QGridLayout* m_grid;
  GapHeadline* m_headline;
  StatementView* m_causes;
  QBoxLayout* m_actions;
  QPushButton *m_addTicked, *m_addLookAlikes, *m_remove;
  RemedyList* m_remedies;
  FormList* m_forms;
  StatementView* m_stages;
  GapMap* m_map;
  LeftoverStrips* m_leftOver;
  DataTable* m_candidates;
  QPushButton* m_add;
  ClosureBars* m_closures;
  QLabel* m_closuresNote;
  QCheckBox* m_withReference;
  QLabel* m_withReferenceNote;
  StatementView *m_required, *m_next, *m_undetectable, *m_known;
  QList<QWidget*> m_blocks;                              ///< in reading order
  QWidget *m_causesBlock, *m_formsBlock, *m_whereBlock;  ///< those of `m_blocks` that are not always shown
  bool m_returnsToReference = false;  ///< true: the switch gets the keyboard again after the diagnosis
};

}  // namespace alidade::ui
