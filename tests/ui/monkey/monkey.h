#pragma once

#include <QStringList>
#include <QTemporaryDir>
#include <functional>
#include <memory>
#include <string>

#include "tests/ui/monkey/chance.h"
#include "tests/ui/monkey/housekeeper.h"
#include "tests/ui/monkey/monkey_hands.h"
#include "ui/jobs/gap_job.h"

namespace alidade::ui {

class MainWindow;

/// Plays with the window: random keys, clicks, pastes, undo, files, pages, while jobs run; closes it and
/// opens another. In between it looks whether all is in order: undo leads to the first state and redo to the
/// last, what is saved is read back, tables and result show the session, and Qt has not warned of anything.
class Monkey {
 public:
  using Tell = std::function<void(const QString& line)>;

  /// `tell` is told of each deed before it is done.
  explicit Monkey(unsigned seed, Tell tell = {});
  ~Monkey();

  /// Ends with the first complaint.
  void play(int events);
  /// What was not in order; empty: all was.
  const QString& complaint() const { return m_complaint; }
  /// The deeds until then, the last few hundred at most.
  const QStringList& log() const { return m_log; }
  /// The session at work, as its file would have it.
  std::string sessionText() const;

 private:
  void openWindow();
  void say(const QString& deed);
  void complain(const QString& what);
  void look();
  bool rest();
  void lookAtFile();
  void lookAtTables();
  void lookAtResult();
  void lookAtGap();
  void lookAtUndo();

  Chance m_chance;
  Tell m_tell;
  QTemporaryDir m_folder;
  QStringList m_log;
  QString m_complaint;
  int m_events = 0;
  std::string m_first;  ///< what undo leads back to
  SharedEvaluation m_evaluation;
  SharedGap m_gap;
  Housekeeper m_housekeeper;
  MonkeyHands m_hands;
  std::unique_ptr<MainWindow> m_window;
};

}  // namespace alidade::ui
