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

/// Operates the window at random: keys, clicks, pastes, undo, files, pages, while jobs run; closes it and
/// opens another. Checks in between: undo and redo reach the first and last state, saved files are read back,
/// tables and result show the session, and Qt gave no warnings.
class Monkey {
 public:
  using Report = std::function<void(const QString& line)>;

  /// `report` receives each action before it is done.
  explicit Monkey(unsigned seed, Report report = {});
  ~Monkey();

  /// Stops at the first complaint.
  void play(int events);
  /// The failed check; empty if all passed.
  const QString& complaint() const { return m_complaint; }
  /// The last few hundred actions.
  const QStringList& log() const { return m_log; }
  /// The current session as its file text.
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
  Report m_report;
  QTemporaryDir m_folder;
  QStringList m_log;
  QString m_complaint;
  int m_events = 0;
  std::string m_first;  ///< the state that undo returns to
  SharedEvaluation m_evaluation;
  SharedGap m_gap;
  Housekeeper m_housekeeper;
  MonkeyHands m_hands;
  std::unique_ptr<MainWindow> m_window;
};

}  // namespace alidade::ui
