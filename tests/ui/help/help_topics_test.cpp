#include "ui/help/help_topics.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QRegularExpression>
#include <QTabBar>
#include <QTest>

#include "tests/ui/language/speaking.h"
#include "tests/ui/support.h"
#include "ui/help/help_window.h"
#include "ui/main_window.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/window/page_tabs.h"

namespace alidade::ui {
namespace {

/// The page in the current language.
QString pageText(const QString& id) {
  QFile page(QStringLiteral(":/help/%1/%2.html").arg(shownLanguage(), id));
  return page.open(QIODevice::ReadOnly) ? QString::fromUtf8(page.readAll()) : QString();
}

/// "words", "words#s0": a page, and optionally an anchor in it.
bool isThere(const QString& topic) {
  const QString text = pageText(topic.section(u'#', 0, 0)), place = topic.section(u'#', 1);
  return !text.isEmpty() && (place.isEmpty() || text.contains(QStringLiteral("name=\"%1\"").arg(place)));
}

class HelpTopics : public testing::TestWithParam<const char*> {
  Speaking m_speaking{QString::fromLatin1(GetParam())};
};

INSTANTIATE_TEST_SUITE_P(Languages, HelpTopics, testing::Values("en", "zh_CN"));

TEST_P(HelpTopics, EachLinkOfEachPageLeadsSomewhere) {
  static const QRegularExpression link(QStringLiteral("href=\"([^\"]*)\""));
  int links = 0;
  for (const HelpPage& page : allHelpPages()) {
    const QString id = QString::fromLatin1(page.id), text = pageText(id);
    ASSERT_FALSE(text.isEmpty()) << page.id;
    for (const auto& match : link.globalMatch(text)) {
      QString to = match.captured(1);
      to = to.startsWith(u'#') ? id + to : to.remove(QStringLiteral(".html"));
      EXPECT_TRUE(isThere(to)) << page.id << " links to " << to.toStdString();
      ++links;
    }
  }
  EXPECT_GT(links, 15);
}

TEST_P(HelpTopics, EachTopicOfAPanelIsWritten) {
  for (const ClassTopic& known : classTopics())
    EXPECT_TRUE(isThere(QString::fromLatin1(known.topic))) << known.topic;
  OpenWindow open;
  for (const QWidget* widget : open->findChildren<QWidget*>())
    EXPECT_TRUE(isThere(helpTopicOf(widget))) << helpTopicOf(widget).toStdString();
}

TEST(HelpWindow, OpensWhereOneStands) {
  OpenWindow open;
  open->document().startWith(paperSession());
  open.waitUntilIdle();
  open->currentTable()->setFocus();
  QTest::keyClick(open.window.get(), Qt::Key_F1);
  auto* help = open->findChild<HelpWindow*>();
  ASSERT_TRUE(help);
  EXPECT_TRUE(help->isVisible());
}

}  // namespace
}  // namespace alidade::ui
