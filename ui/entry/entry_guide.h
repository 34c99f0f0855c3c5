#pragma once

#include <QObject>
#include <cstddef>
#include <optional>
#include <string>

#include "core/base/problem.h"
#include "core/session/entry_to_come.h"
#include "core/statement/headline.h"
#include "ui/document/reading_column.h"
#include "ui/jobs/fit_job.h"

class QKeyEvent;
class QWidget;

namespace alidade::ui {

class BenchDisplay;
class PositionTabs;
class SessionDocument;
struct SessionChange;

/// Moves the keyboard focus to the next missing entry; reports the next reading, and doubts about typed ones.
class EntryGuide : public QObject {
  Q_OBJECT

 public:
  EntryGuide(SessionDocument& document, PositionTabs& positions, QWidget& window);

  /// Focuses the next entry of a position at axis angle `axisDeg` (0 or 180). The search starts after the
  /// position that has the focus, if any. Asks for a new position if none has this axis angle.
  void goToAxis(int axisDeg);
  /// Focuses the next missing entry (`entryToLeadTo`): a missing length comes first.
  void goToNextEntry();
  void setLargeDisplayShown(bool shown);
  void toggleLargeDisplay();
  void setEvaluation(const SharedEvaluation& evaluation);
  void setHeadline(const Headline& headline);

 signals:
  void commitWanted();  ///< asks to commit unfinished entries before the focus moves
  void revealWanted(const Place& place);
  void positionWanted(int axisDeg);
  void nextChanged(const QString& text);  ///< names the next reading; empty before the first evaluation
  void remark(const QString& text);

 private:
  void goToNextEntryOf(std::size_t position);
  void goTo(const EntryToCome& next);
  void goToMissingOf(std::size_t position, const std::string& zero);
  void goOnSoon(bool isFromZero);
  void goOn(bool isFromZero);
  void takeDigit(QKeyEvent& event);
  void reportEntry(std::size_t position, std::size_t row, ReadingColumn column, const QString& doubt);
  void dropDoubt(const SessionChange& change);
  void showNext();

  SessionDocument& m_document;
  PositionTabs& m_positions;
  QWidget& m_window;
  BenchDisplay* m_bench = nullptr;  ///< null until first shown
  SharedEvaluation m_evaluation;    ///< null before the first evaluation
  Headline m_headline;

  struct Doubted {
    std::size_t position, row;
    ReadingColumn column;
    std::string typed;
  };
  std::optional<Doubted> m_doubted;  ///< the reading that the Large Display doubts
};

}  // namespace alidade::ui
