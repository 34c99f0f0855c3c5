#pragma once

#include <QDialog>
#include <QList>

#include "ui/text/session_difference.h"

class QLabel;
class QListWidget;
class QStackedWidget;

namespace alidade::ui {

/// Unsaved changes of a crashed window.
struct RecoveryOffer {
  QString name;     ///< name of the file; for an unsaved session its title or “Untitled”
  QString details;  ///< folder, time of the changes, state of the file
  SessionDifference difference;
};

struct RecoveryAnswer {
  enum class Choice { Later, Recover, Discard };

  Choice choice = Choice::Later;
  int index = 0;  ///< index of the offer
};

/// Offers unsaved changes, each compared with its file. Discarding requires a confirmation.
class RecoveryDialog : public QDialog {
  Q_OBJECT

 public:
  RecoveryDialog(const QList<RecoveryOffer>& offers, QWidget* parent);

  RecoveryAnswer ask();

 private:
  void addOffer(const RecoveryOffer& offer);
  QWidget* createButtons();
  bool isDiscardConfirmed();

  QListWidget* m_names;
  QStackedWidget* m_offers;
  RecoveryAnswer m_answer;
};

}  // namespace alidade::ui
