#pragma once

#include <QWidget>

class QPushButton;
class QTreeWidget;

namespace alidade::ui {

/// What to begin with, instead of an empty session: a new one, a file, a sample, the guide.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);

  /// Reads the list of recent files anew.
  void refresh();
  /// To where one most likely goes on: the newest file, or else a new session.
  void focusFirst();

 signals:
  void newWanted();
  void openWanted();
  void importWanted();
  void guideWanted();
  void fileWanted(const QString& path);
  void sampleWanted(const QString& name);
  /// Back to the session at work; `typed`, if any, goes on there.
  void sessionWanted(const QString& typed);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* createActions();
  QWidget* createLists();
  void fillSamples();

  QPushButton* m_new = nullptr;
  QTreeWidget *m_recent, *m_samples;
};

}  // namespace alidade::ui
