#pragma once

#include <QWidget>

class QPushButton;
class QTreeWidget;

namespace alidade::ui {

/// The first choices instead of an empty session: a new session, a file, a sample, the guide.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);

  /// Reads the list of recent files again.
  void refresh();
  /// Focuses the most likely choice: the newest file, or else a new session.
  void focusFirst();

 signals:
  void newWanted();
  void openWanted();
  void importWanted();
  void guideWanted();
  void fileWanted(const QString& path);
  void sampleWanted(const QString& name);
  /// Returns to the current session, and forwards `typed`, if any.
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
