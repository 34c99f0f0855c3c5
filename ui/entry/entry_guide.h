#pragma once

#include <QObject>
#include <cstddef>
#include <optional>

#include "core/base/place.h"
#include "core/session/entry_to_come.h"
#include "ui/jobs/fit_job.h"
#include "ui/text/headline.h"

class QKeyEvent;
class QWidget;

namespace alidade::ui {

class BenchDisplay;
class PositionTabs;
class SessionDocument;

/// Leads the keyboard to what is to be typed next, and says what is expected there and what was not as
/// expected.
class EntryGuide : public QObject {
  Q_OBJECT

 public:
  EntryGuide(SessionDocument& document, PositionTabs& positions, QWidget& window);

  /// Leads to the next entry of the readings at `axisDeg` (0 or 180); asked again where it is there already,
  /// to those of the next position at that axis.
  void goToAxis(int axisDeg);
  /// Leads to what is to be typed next: a length that is missing, then what `entryToCome` says.
  void goToNextEntry();
  void setLargeDisplayShown(bool shown);
  void setEvaluation(const SharedEvaluation& evaluation);
  void setHeadline(const Headline& headline);

 signals:
  void commitWanted();  ///< what is half typed belongs into the session first
  void revealWanted(const Place& place);
  void positionWanted(int axisDeg);
  void nextChanged(const QString& text);  ///< what is to be read next; may be empty
  void remark(const QString& text);

 private:
  void goToNextEntryOf(std::size_t position);
  std::optional<std::size_t> zeroBefore(const EntryToCome& next) const;
  void goTo(const EntryToCome& next);
  void goToMissingOf(std::size_t position, const std::string& zero);
  void goOn();
  void takeDigit(QKeyEvent& event);
  void tellOfEntry(const QString& doubt);
  void showNext();

  SessionDocument& m_document;
  PositionTabs& m_positions;
  QWidget& m_window;
  BenchDisplay* m_bench = nullptr;  ///< null until it is wanted
  SharedEvaluation m_evaluation;    ///< null before the first
  Headline m_headline;
};

}  // namespace alidade::ui
