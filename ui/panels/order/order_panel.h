#pragma once

#include <QWidget>
#include <cstddef>
#include <optional>

#include "ui/jobs/outlook_job.h"

class QLabel;
class QMenu;
class QProgressBar;
class QToolButton;

namespace alidade::ui {

class DataTable;
class SessionDocument;

/// The protocol that the session follows: the next sighting with what it will read, how much is left, what to
/// take again and why, when it is enough, and all sightings in their order. Chooses another protocol.
class OrderPanel : public QWidget {
  Q_OBJECT

 public:
  explicit OrderPanel(SessionDocument& document, QWidget* parent = nullptr);

  void setEvaluation(const SharedEvaluation& evaluation);
  /// The same evaluation with what looks misread, when it is there.
  void setSearched(const SharedEvaluation& evaluation);
  /// The diagnosis, when it is there: Δd as measured is its, and what it advises can be followed.
  void setGap(const SharedGap& gap);
  OutlookJob& job() { return m_job; }

 signals:
  void placeActivated(const Place& place);
  void commitWanted();
  void loadWanted();  ///< a protocol from a file
  void saveWanted();  ///< the protocol to a file
  void editWanted();  ///< the protocol in a form

 private:
  DataTable* createTable();
  QWidget* createSummary();
  void fillMenu();
  void follow(const std::optional<SightingProtocol>& protocol);
  void showSummary();
  void showNext();
  void goToNext();
  void showOutlook(const SharedOutlook& outlook);
  void requestOutlook();
  const Guide* guideThatLeads() const;  ///< null without a protocol, or where it means nothing
  SharedGap gapOfThis() const;          ///< null where it is of another state
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
  SharedEvaluation m_searched;    ///< the newest one with what looks misread; null before the first
  SharedGap m_gap;                ///< the newest; null before the first
  OutlookJob m_job;
  QToolButton* m_choice;
  QMenu* m_menu;
  QProgressBar* m_progress;
  QLabel *m_next, *m_expected, *m_state, *m_outlook, *m_repeats;
  DataTable* m_table;
  ListedNext m_listedNext;  ///< where the list was led to
};

}  // namespace alidade::ui
