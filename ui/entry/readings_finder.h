#pragma once

#include <QObject>
#include <QString>

#include "core/base/place.h"

namespace alidade::ui {

class FindBar;
class PositionTabs;
class SessionDocument;

/// Leads through the places of a text in the readings.
class ReadingsFinder : public QObject {
  Q_OBJECT

 public:
  ReadingsFinder(SessionDocument& document, PositionTabs& positions, FindBar& bar);

  void find();                   ///< asks for a text
  void findAgain(bool forward);  ///< the one looked for last; asks where there is none

 signals:
  void commitWanted();  ///< what is half typed is looked through, too
  void found(const Place& place, bool takeFocus);

 private:
  void findText(const QString& text, bool forward);

  SessionDocument& m_document;
  PositionTabs& m_positions;
  FindBar& m_bar;
  QString m_text;  ///< looked for last
};

}  // namespace alidade::ui
