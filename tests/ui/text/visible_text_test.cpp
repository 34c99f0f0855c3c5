#include "ui/text/visible_text.h"

#include <gtest/gtest.h>

#include <QStringList>

#include "tests/support/hostile.h"

namespace alidade::ui {
namespace {

QString of(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

TEST(VisibleText, IsOneLineWithNothingHidden) {
  for (const test::HostileText& hostile : test::hostileTexts) {
    const QString text = of(hostile.text);
    EXPECT_FALSE(test::firstForbidden(visibleLine(text).toStdString(), "")) << hostile.what;
    EXPECT_FALSE(test::firstForbidden(visibleLines(text).toStdString(), "\n\t")) << hostile.what;
    EXPECT_FALSE(test::firstForbidden(menuText(text).toStdString(), "")) << hostile.what;
    EXPECT_FALSE(test::firstForbidden(tipText(text).toStdString(), "\n\t")) << hostile.what;
  }
  EXPECT_EQ(visibleLine(of("a\nb\u202E")), of("a\\u000ab\\u202e"));
  EXPECT_EQ(visibleLines(of("a\r\nb\n\tc\r")), of("a\nb\n\tc\\u000d"));
}

// Every character accepted by the fast path is also accepted by the full check.
TEST(VisibleText, LetsNothingPassAtAGlanceThatIsHidden) {
  for (char16_t code = 0; code < 0xD800; ++code) {
    const QString one(QChar{code}), careful = visibleLine(one + of("\x1b"));
    EXPECT_EQ(visibleLine(one) + of("\\u001b"), careful) << static_cast<int>(code);
  }
}

TEST(VisibleText, OfAMenuIsShortAndShowsItsAmpersands) {
  EXPECT_EQ(menuText(of("Smith & Sons\tCtrl+Q")), of("Smith && Sons\\u0009Ctrl+Q"));
  EXPECT_EQ(menuText(QString(10000, u'x')).size(), 61);
  EXPECT_EQ(shortLine(QString(5, u'x'), 4), of("xxxx…"));
}

TEST(VisibleText, OfATipFitsAScreen) {
  const QString long1 = tipText(QString(10000, u'x'));
  const QStringList lines = long1.split(u'\n');
  EXPECT_EQ(lines.size(), 25);
  for (const QString& line : lines) EXPECT_LE(line.size(), 90);
  EXPECT_EQ(tipText(of("one\ntwo")), of("one\ntwo"));
  EXPECT_EQ(tipText(QString(80, u'x') + of(" ") + QString(20, u'y')),
            QString(80, u'x') + of("\n ") + QString(20, u'y'));
}

}  // namespace
}  // namespace alidade::ui
