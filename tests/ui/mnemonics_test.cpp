#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QKeySequence>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QTabWidget>
#include <map>

#include "tests/ui/support.h"
#include "ui/dialogs/blind_trial_dialog.h"
#include "ui/main_window.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/window/side_windows.h"

// Alt and a letter trigger a single action, whatever is in front.

namespace alidade::ui {
namespace {

class Mnemonics {
 public:
  void add(const QString& text) {
    const QKeySequence keys = QKeySequence::mnemonic(text);
    if (!keys.isEmpty()) m_texts[keys.toString()].append(text);
  }
  void addVisibleOf(const QWidget& window) {
    for (const QTabBar* bar : visible<QTabBar>(window))
      for (int tab = 0; tab < bar->count(); ++tab)
        if (bar->isTabVisible(tab)) add(bar->tabText(tab));
    for (const QLabel* label : visible<QLabel>(window))
      if (label->buddy()) add(label->text());
    for (const QAbstractButton* button : visible<QAbstractButton>(window)) add(button->text());
  }
  std::string twice() const {
    QString found;
    for (const auto& [keys, texts] : m_texts)
      if (texts.size() > 1) found += keys + QStringLiteral(": ") + texts.join(QStringLiteral(" / ")) + u'\n';
    return found.toStdString();
  }

 private:
  template <typename Widget>
  static QList<Widget*> visible(const QWidget& window) {
    QList<Widget*> found;
    for (Widget* widget : window.findChildren<Widget*>())
      if (widget->isVisible() && widget->window() == &window) found.append(widget);
    return found;
  }

  std::map<QString, QStringList> m_texts;
};

TEST(Mnemonics, LeadToOneThingWhateverIsInFront) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("two-faces.alidade"))));
  open.waitUntilIdle();
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  auto* forms = open->findChild<QTabWidget*>(QStringLiteral("forms"));
  ASSERT_TRUE(forms);
  ASSERT_EQ(forms->count(), 4);
  const QList<PageTabs*> tabs = open->pageTabs();
  int shown = 0;
  for (int form = 0; form < forms->count(); ++form)
    for (int figure = 0; figure < tabs[0]->count(); ++figure)
      for (int detail = 0; detail < tabs[1]->count(); ++detail) {
        forms->setCurrentIndex(form);
        tabs[0]->setCurrentIndex(figure);
        tabs[1]->setCurrentIndex(detail);
        QApplication::processEvents();
        Mnemonics mnemonics;
        for (const QAction* menu : open->menuBar()->actions()) mnemonics.add(menu->text());
        mnemonics.addVisibleOf(*open.window);
        EXPECT_EQ(mnemonics.twice(), "") << "form " << form << ", pages " << figure << ", " << detail;
        ++shown;
      }
  EXPECT_EQ(shown, 4 * 3 * 7);
}

TEST(Mnemonics, LeadToOneThingInMenusAndInTheBlindTrial) {
  OpenWindow open;
  for (const QAction* top : open->menuBar()->actions()) {
    Mnemonics mnemonics;
    for (const QAction* action : top->menu()->actions()) mnemonics.add(action->text());
    EXPECT_EQ(mnemonics.twice(), "") << top->text().toStdString();
  }
  open->sideWindows().showBlindTrials();
  Mnemonics mnemonics;
  mnemonics.addVisibleOf(*open->findChild<BlindTrialDialog*>());
  EXPECT_EQ(mnemonics.twice(), "");
}

}  // namespace
}  // namespace alidade::ui
