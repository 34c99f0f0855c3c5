#pragma once

#include <QWidget>
#include <cstddef>
#include <optional>

#include "ui/jobs/outlook_job.h"

class QDoubleSpinBox;
class QLabel;
class QMenu;
class QProgressBar;
class QToolButton;

namespace alidade::ui {

class DataTable;
class SessionDocument;
class StatementView;

/// Shows the session's protocol: the next sighting with its expected readings, the remaining sightings, what
/// to repeat and why, and all sightings in order. States the U that the protocol reaches or, in a protocol by
/// worth, the sightings that reach a wanted U. The user can choose another protocol.
class OrderPanel : public QWidget {
  Q_OBJECT

 public:
  explicit OrderPanel(SessionDocument& document, QWidget* parent = nullptr);

  void setEvaluation(const SharedEvaluation& evaluation);
  /// The same evaluation after the search for misread readings.
  void setSearched(const SharedEvaluation& evaluation);
  /// The finished diagnosis: it supplies Δd, measured, and advice to follow.
  void setGap(const SharedGap& gap);
  OutlookJob& job() { return m_job; }

 signals:
  void placeActivated(const Place& place);
  void commitWanted();
  void loadWanted();  ///< asks to load a protocol from a file
  void saveWanted();  ///< asks to save the protocol to a file
  void editWanted();  ///< asks to edit the protocol in a form

 private:
  DataTable* createTable();
  QWidget* createSummary();
  QWidget* createUncertainty();
  void fillMenu();
  void follow(const std::optional<SightingProtocol>& protocol);
  void showSummary();
  void showNext();
  void goToNext();
  void showOutlook(const SharedOutlook& outlook);
  QString outlookText(const OutlookOfSession& outlook) const;
  void requestOutlook();
  void requestAhead();                  ///< for a protocol by worth
  const Guide* guideThatLeads() const;  ///< null if there is no protocol or it is invalid
  SharedGap gapOfThis() const;          ///< null if `m_gap` belongs to another state of the session
  const FollowedSighting& sighting(int row) const;
  QString expectedText(int row, bool isHorizontal) const;
  QString remarkText(int row) const;
  void activate(int row);

  struct ListedNext {
    int rows = 0;
    std::optional<std::size_t> next;

    bool operator==(const ListedNext&) const = default;
  };

  SessionDocument& m_document;
  SharedEvaluation m_evaluation;  ///< never null
  SharedEvaluation m_searched;    ///< the newest with a finished search; null before the first
  SharedGap m_gap;                ///< the newest diagnosis; null before the first
  OutlookJob m_job;
  QToolButton* m_choice;
  QMenu* m_menu;
  QProgressBar* m_progress;
  QLabel *m_next, *m_expected, *m_state, *m_outlook, *m_repeats;
  QDoubleSpinBox* m_uncertainty;      ///< U to reach, mm; 0: none
  bool m_isUncertaintyTyped = false;  ///< false: `m_uncertainty` follows the tolerance
  StatementView* m_choiceMade;        ///< why this sighting is next; only in a protocol by worth
  StatementView* m_ahead;             ///< by worth: sightings that reach U; else: alternatives to more rounds
  DataTable* m_table;
  ListedNext m_listedNext;  ///< the sighting last scrolled to
};

}  // namespace alidade::ui
