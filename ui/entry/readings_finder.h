#pragma once

#include <QObject>
#include <QString>

#include "core/base/problem.h"

namespace alidade::ui {

class FindBar;
class PositionTabs;
class SessionDocument;

/// Finds a text in the readings, one occurrence after the other.
class ReadingsFinder : public QObject {
  Q_OBJECT

 public:
  ReadingsFinder(SessionDocument& document, PositionTabs& positions, FindBar& bar);

  void find();                   ///< asks for a text
  void findAgain(bool forward);  ///< finds the last text again; asks if there is none

 signals:
  void commitWanted();  ///< asks to commit unfinished entries, so that they are searched too
  void found(const Place& place, bool takeFocus);

 private:
  void findText(const QString& text, bool forward);

  SessionDocument& m_document;
  PositionTabs& m_positions;
  FindBar& m_bar;
  QString m_text;  ///< the text searched last
};

}  // namespace alidade::ui
