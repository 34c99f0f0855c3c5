#pragma once

#include <QDialog>
#include <QList>

#include "ui/text/session_difference.h"

class QLabel;
class QListWidget;
class QStackedWidget;

namespace alidade::ui {

/// Unsaved changes that a window left behind.
struct RecoveryOffer {
  QString name;  ///< of the file, or what stands for a session in none
  QString told;  ///< where it is, when the changes were kept, what became of the file
  SessionDifference difference;
};

struct RecoveryAnswer {
  enum class Choice { Later, Recover, Discard };

  Choice choice = Choice::Later;
  int index = 0;  ///< of the offer
};

/// Offers what was left behind, each beside its file. Nothing is discarded unless that is confirmed.
class RecoveryDialog : public QDialog {
  Q_OBJECT

 public:
  RecoveryDialog(const QList<RecoveryOffer>& offers, QWidget* parent);

  RecoveryAnswer ask();

 private:
  void addOffer(const RecoveryOffer& offer);
  QWidget* createButtons();
  bool isDiscardMeant();

  QListWidget* m_names;
  QStackedWidget* m_offers;
  RecoveryAnswer m_answer;
};

}  // namespace alidade::ui
