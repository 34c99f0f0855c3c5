#pragma once

#include <QWidget>

#include "ui/jobs/evaluation.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace alidade::ui {

class SessionDocument;

/// The catalogue of effects: a tick estimates one along with the arcs, and its size stands beside it. Ticks
/// follow the session, sizes the newest evaluation.
class EffectsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit EffectsPanel(SessionDocument& document, QWidget* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation);

 private:
  QTreeWidgetItem* addItem(const std::string& id, const QString& name);
  void addUnknown();
  void refreshTicks();
  void handIn(QTreeWidgetItem* item);
  void explain(const QTreeWidgetItem* item);

  SessionDocument& m_document;
  QTreeWidget* m_list;
  QLabel* m_about;
};

}  // namespace alidade::ui
