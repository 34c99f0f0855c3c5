#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QSet>

#include "core/base/version.h"
#include "tests/ui/language/speaking.h"
#include "tests/ui/shown_texts.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/settings/recent_files.h"

// A text that was not extracted for translation appears in English in a Chinese window.

namespace alidade::ui {
namespace {

using namespace Qt::StringLiterals;

/// The session without its author's words, which are never translated.
Session wordless(Session session) {
  for (std::string* text :
       {&session.title, &session.notes, &session.operatorName, &session.place, &session.device.name,
        &session.device.serial, &session.instrument.name, &session.instrument.serial})
    text->clear();
  for (Position& position : session.positions)
    for (Reading& reading : position.readings) reading.note.clear();
  return session;
}

/// Words of two or more letters, except symbols and names.
QStringList englishIn(const QString& text) {
  static const QRegularExpression word(QStringLiteral("[A-Za-z]{2,}"));
  static const QSet<QString> intended{
      // units, symbols, functions
      u"mm"_s, u"ppm"_s, u"gon"_s, u"ln"_s, u"sin"_s, u"cos"_s, u"tan"_s, u"atan"_s, u"exp"_s, u"DMS"_s,
      u"dms"_s, u"deg"_s, u"mgon"_s, u"mrad"_s, u"rad"_s,
      // keys
      u"Ctrl"_s, u"Shift"_s, u"Alt"_s, u"Tab"_s, u"Enter"_s, u"Esc"_s, u"Space"_s, u"Del"_s, u"Ins"_s,
      u"Home"_s, u"End"_s, u"Up"_s, u"Down"_s, u"Left"_s, u"Right"_s, u"PgUp"_s, u"PgDown"_s, u"Return"_s,
      u"Backspace"_s, u"Delete"_s, u"Page"_s,
      // formats and standards
      u"GSI"_s, u"CSV"_s, u"PDF"_s, u"JSON"_s, u"SVG"_s, u"PNG"_s, u"SDR"_s, u"SHA"_s, u"UTF"_s, u"DCC"_s,
      u"GeoCOM"_s, u"ISO"_s, u"IEC"_s, u"JCGM"_s, u"ILAC"_s, u"GUM"_s, u"alidade"_s, u"txt"_s, u"gsi"_s,
      u"UTC"_s, u"csv"_s, u"pdf"_s, u"json"_s, u"svg"_s, u"png"_s,
      // words of a session file, to be typed unchanged
      u"inclination"_s, u"standing"_s, u"collimation"_s, u"tilting"_s, u"axis"_s, u"none"_s,
      // names
      u"Alidade"_s, u"Leica"_s, u"Trimble"_s, u"Sokkia"_s, u"English"_s, u"DejaVu"_s, u"Sans"_s, u"Letter"_s};
  QStringList words;
  for (const auto& match : word.globalMatch(text))
    if (!intended.contains(match.captured())) words.append(match.captured());
  return words;
}

void expectChinese(QWidget& window, const std::string& when) {
  QStringList seen;
  for (const ShownText& shown : shownTexts(window)) {
    if (shown.where.contains(QStringLiteral("QSpinBox")) || seen.contains(shown.text)) continue;
    seen.append(shown.text);
    const QString text = QString(shown.text).remove(QString::fromUtf8(programBuild));
    EXPECT_EQ(englishIn(text).join(u' ').toStdString(), "")
        << when << ": " << shown.where.toStdString() << ": " << shown.text.toStdString();
  }
}

class ChineseWindow : public testing::TestWithParam<const char*> {
 protected:
  ChineseWindow() { RecentFiles::clear(); }

  Speaking speaking{QStringLiteral("zh_CN")};
};

TEST_P(ChineseWindow, SaysNothingInEnglish) {
  OpenWindow open;
  SessionDocument sample;
  ASSERT_FALSE(sample.load(samplePath(QStringLiteral("%1.alidade").arg(QString::fromLatin1(GetParam())))));
  open->document().startWith(wordless(sample.session()));
  open.waitUntilIdle();
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  for (PageTabs* tabs : open->pageTabs())
    for (int page = 0; page < tabs->count(); ++page) tabs->setCurrentIndex(page);
  expectChinese(*open.window, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Samples, ChineseWindow,
                         testing::Values("paper-table-1", "trunnion-tilt", "two-faces", "look-alikes",
                                         "misreading", "knocked-tripod", "two-causes", "unknown-form",
                                         "dented-guideway", "settling-tripod", "noisy-readings",
                                         "clean-session"));

}  // namespace
}  // namespace alidade::ui
