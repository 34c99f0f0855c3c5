#pragma once

#include <QObject>
#include <cstddef>
#include <optional>

#include "core/base/place.h"
#include "core/session/entry_to_come.h"
#include "core/statement/headline.h"
#include "ui/jobs/fit_job.h"

class QKeyEvent;
class QWidget;

namespace alidade::ui {

class BenchDisplay;
class PositionTabs;
class SessionDocument;

/// Leads the keyboard to the next missing entry, and reports expected readings and deviations from them.
class EntryGuide : public QObject {
  Q_OBJECT

 public:
  EntryGuide(SessionDocument& document, PositionTabs& positions, QWidget& window);

  /// Leads to the next entry of a position at axis angle `axisDeg` (0 or 180). If such a position has the
  /// focus, leads to the next position at that axis angle.
  void goToAxis(int axisDeg);
  /// Leads to the next missing entry: a missing length, then `entryToCome`.
  void goToNextEntry();
  void setLargeDisplayShown(bool shown);
  void toggleLargeDisplay();
  void setEvaluation(const SharedEvaluation& evaluation);
  void setHeadline(const Headline& headline);

 signals:
  void commitWanted();  ///< unfinished entries must be committed first
  void revealWanted(const Place& place);
  void positionWanted(int axisDeg);
  void nextChanged(const QString& text);  ///< the next reading; may be empty
  void remark(const QString& text);

 private:
  void goToNextEntryOf(std::size_t position);
  void goTo(const EntryToCome& next);
  void goToMissingOf(std::size_t position, const std::string& zero);
  void goOn();
  void takeDigit(QKeyEvent& event);
  void reportEntry(const QString& doubt);
  void showNext();

  SessionDocument& m_document;
  PositionTabs& m_positions;
  QWidget& m_window;
  BenchDisplay* m_bench = nullptr;  ///< null until first shown
  SharedEvaluation m_evaluation;    ///< null before the first
  Headline m_headline;
};

}  // namespace alidade::ui
