#pragma once

#include "core/evaluation/remedies.h"
#include "ui/jobs/gap_job.h"
#include "ui/panels/parts/scroll_page.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace alidade::ui {

class CauseList;
class ClosureBars;
class DataTable;
class FigureGrid;
class FormList;
class GapHeadline;
class GapMap;
class GapWaterfall;
class LeftoverStrips;

/// The gap between model and readings: verdict, causes, forms, how far it shrinks, its place, all candidates,
/// what to measure next and undetectable effects. Only emits signals.
class GapPanel : public ScrollPage {
  Q_OBJECT

 public:
  explicit GapPanel(QWidget* parent = nullptr);

  void setGap(const SharedGap& gap);
  /// The session changed: the old contents stay, with actions disabled until the new diagnosis.
  void setStale();
  /// Another session, not diagnosed yet.
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
  void formWanted(const alidade::FoundForm& form);  ///< is to be kept as an effect
  void noiseWanted(const alidade::StatedNoise& noise);
  void referenceWanted(bool wanted);  ///< whether the causes are to be weighed with the reference

 protected:
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* createCandidates();
  void arrange();
  void showVerdict();
  void showEffectOnResult();
  void showShrinkage();
  void showClosures();
  void showReference();
  void showRequired();
  void showNext();
  void showUndetectable();
  void showCandidate();
  void addCandidate();
  /// The candidate in `row`; null if there is none.
  const Candidate* candidate(int row) const;
  bool isInModel(const std::string& id) const;

  SharedGap m_gap;
  QGridLayout* m_grid;
  GapHeadline* m_headline;
  CauseList* m_causes;
  FormList* m_forms;
  GapWaterfall* m_waterfall;
  FigureGrid* m_result;
  QLabel* m_shrinkage;
  GapMap* m_map;
  LeftoverStrips* m_leftOver;
  DataTable* m_candidates;
  QPushButton* m_add;
  ClosureBars* m_closures;
  QLabel* m_closuresNote;
  QCheckBox* m_withReference;
  QLabel* m_withReferenceNote;
  FigureGrid* m_required;
  QLabel* m_requiredNote;
  QLabel* m_next;
  FigureGrid* m_undetectable;
  QLabel* m_undetectableNote;
  QList<QWidget*> m_blocks;                                ///< in reading order
  QWidget *m_formsBlock, *m_whereBlock, *m_requiredBlock;  ///< of `m_blocks`, not always shown
  bool m_returnsToReference = false;  ///< gives the keyboard back to the switch after the diagnosis
};

}  // namespace alidade::ui
