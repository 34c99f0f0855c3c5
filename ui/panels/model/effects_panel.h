#pragma once

#include <QWidget>

#include "core/evaluation/evaluation.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace alidade::ui {

class SessionDocument;

/// The catalogue of effects: ticking an effect estimates its size along with the arcs. Ticks follow the
/// session, sizes the newest evaluation.
class EffectsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit EffectsPanel(SessionDocument& document, QWidget* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation);

 signals:
  /// Asks to type a known size of this effect; empty: of an effect still to be chosen.
  void knownWanted(const std::string& effect);
  /// Asks to change this effect of the user's own; empty: to type a new one.
  void ownWanted(const std::string& id);

 private:
  QTreeWidgetItem* addItem(const std::string& id, const QString& name);
  void addUnknown();
  void refreshTicks();
  void handIn(QTreeWidgetItem* item);
  void explain(const QTreeWidgetItem* item);
  void askForKnown();

  SessionDocument& m_document;
  QTreeWidget* m_list;
  QLabel* m_about;
};

}  // namespace alidade::ui
