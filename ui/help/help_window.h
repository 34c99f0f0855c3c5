#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;

namespace alidade::ui {

/// Shows the contents of the guide, one page, and a search in that page. May stay open next to the window.
class HelpWindow : public QWidget {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent = nullptr);

  void showTopic(const QString& topic);
  QTextBrowser& browser() const { return *m_browser; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* createBar();
  void find(bool backward);
  void followPage(const QUrl& page);
  void style();

  QListWidget* m_contents;
  QTextBrowser* m_browser;
  QLineEdit* m_search = nullptr;
  QLabel* m_notFound = nullptr;
};

}  // namespace alidade::ui
