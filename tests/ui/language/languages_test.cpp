#include "ui/language/languages.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <thread>

#include "core/base/phrase.h"
#include "tests/ui/language/speaking.h"

namespace alidade::ui {
namespace {

QString undoText() {
  return QCoreApplication::translate("alidade::ui::WindowActions", "&Undo");
}

TEST(Languages, NoneOfOursIsThatOfTheDesktop) {
  EXPECT_EQ(languageOr(QStringLiteral("zh_CN")), QStringLiteral("zh_CN"));
  EXPECT_EQ(languageOr(QStringLiteral("en")), QStringLiteral("en"));
  EXPECT_EQ(languageOr(QStringLiteral("tlh")), languageOr({}));
}

TEST(Languages, AreRememberedUntilNoneIsChosen) {
  EXPECT_EQ(rememberedLanguage(), QString());
  rememberLanguage(QStringLiteral("zh_CN"));
  EXPECT_EQ(rememberedLanguage(), QStringLiteral("zh_CN"));
  rememberLanguage({});
  EXPECT_EQ(rememberedLanguage(), QString());
}

TEST(Languages, AreSpokenByWindowAndCoreAlike) {
  const Speaking speaking(QStringLiteral("zh_CN"));
  EXPECT_EQ(shownLanguage(), QStringLiteral("zh_CN"));
  EXPECT_EQ(undoText(), QStringLiteral("撤销(&U)"));
  EXPECT_NE(Phrase::of("readings"), "readings");
}

TEST(Languages, OfAScopeAreThoseOfItsThreadAlone) {
  const Speaking speaking(QStringLiteral("en"));
  const LanguageScope scope(QStringLiteral("zh_CN"));
  EXPECT_EQ(undoText(), QStringLiteral("撤销(&U)"));
  {
    const LanguageScope inner(QStringLiteral("en"));
    EXPECT_EQ(undoText(), QStringLiteral("&Undo"));
    const LanguageScope unknown(QStringLiteral("tlh"));
    EXPECT_EQ(shownLanguage(), QStringLiteral("en"));
  }
  EXPECT_EQ(shownLanguage(), QStringLiteral("zh_CN"));
  QString elsewhere;
  std::thread([&] { elsewhere = undoText(); }).join();
  EXPECT_EQ(elsewhere, QStringLiteral("&Undo"));
}

struct Entry {
  QString context, source, translation, state;
};

/// All entries of the translation list.
std::vector<Entry> entriesOfList() {
  QFile file(QStringLiteral(ALIDADE_LANGUAGES_DIR "/alidade_zh_CN.ts"));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  std::vector<Entry> entries;
  QString context;
  for (QXmlStreamReader xml(&file); !xml.atEnd();) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == u"name") context = xml.readElementText();
    if (xml.name() == u"source") entries.push_back({context, xml.readElementText(), {}, {}});
    if (xml.name() != u"translation") continue;
    entries.back().state = xml.attributes().value(QStringLiteral("type")).toString();
    entries.back().translation = xml.readElementText();
  }
  return entries;
}

QStringList found(const QString& text, const char* pattern) {
  QStringList marks;
  for (const auto& match : QRegularExpression(QString::fromLatin1(pattern)).globalMatch(text))
    marks.append(match.captured());
  marks.sort();
  return marks;
}

// The check rules.texts ensures that the list has every text of the sources.
TEST(Translations, AreThereForEveryText) {
  const std::vector<Entry> entries = entriesOfList();
  EXPECT_GT(entries.size(), 1500u);
  for (const Entry& entry : entries) {
    const std::string message = entry.context.toStdString() + ": " + entry.source.toStdString();
    EXPECT_EQ(entry.state, QString()) << message;
    EXPECT_FALSE(entry.translation.isEmpty()) << message;
  }
}

TEST(Translations, HaveTheMarksAndMnemonicsOfTheirTexts) {
  for (const Entry& entry : entriesOfList())
    for (const char* pattern : {"%[1-9n]", "\\[\\*\\]", "\t.*", "<[^>]*>", "\\(\\*\\.[^)]*\\)"})
      EXPECT_EQ(found(entry.translation, pattern), found(entry.source, pattern))
          << entry.source.toStdString() << "\n"
          << entry.translation.toStdString();
  for (const Entry& entry : entriesOfList())
    EXPECT_EQ(found(entry.translation, "&[^& ]").size(), found(entry.source, "&[^& ]").size())
        << entry.source.toStdString() << "\n"
        << entry.translation.toStdString();
}

}  // namespace
}  // namespace alidade::ui
