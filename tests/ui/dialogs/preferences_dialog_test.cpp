#include "ui/dialogs/preferences_dialog.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include "core/session/sighting_protocol.h"
#include "core/simulation/protocol.h"
#include "core/wording/guidance.h"
#include "tests/ui/support.h"
#include "ui/dialogs/file_flow.h"
#include "ui/document/session_template.h"
#include "ui/language/languages.h"
#include "ui/main_window.h"
#include "ui/report/report_choice.h"
#include "ui/settings/entry_tone.h"
#include "ui/settings/theme.h"

namespace alidade::ui {
namespace {

class PreferencesTest : public testing::Test {
 protected:
  ~PreferencesTest() override {
    applyTheme(Theme::System);
    applyFont({});
    QApplication::setFont(m_font);
    QSettings().clear();
  }

  template <typename Widget>
  Widget& in(PreferencesDialog& dialog, const char* name) {
    auto* found = dialog.findChild<Widget*>(QString::fromLatin1(name));
    EXPECT_TRUE(found) << name;
    return *found;
  }
  void type(PreferencesDialog& dialog, const char* field, const char* text) {
    auto& line = in<QLineEdit>(dialog, field);
    line.selectAll();
    QTest::keyClicks(&line, QString::fromUtf8(text));
  }
  void choose(QComboBox& box, const QVariant& data) { box.setCurrentIndex(box.findData(data)); }

  QFont m_font = QApplication::font();
  ScriptedDialogs dialogs;
};

TEST_F(PreferencesTest, KeepsWhatIsAccepted) {
  PreferencesDialog dialog(dialogs);
  choose(in<QComboBox>(dialog, "language"), QStringLiteral("zh_CN"));
  choose(in<QComboBox>(dialog, "colours"), static_cast<int>(Theme::Dark));
  in<QCheckBox>(dialog, "tone").setChecked(true);
  choose(in<QComboBox>(dialog, "paper"), QPageSize::Letter);
  choose(in<QComboBox>(dialog, "report language"), QStringLiteral("en"));
  dialogs.font = QFont(QStringLiteral("DejaVu Serif"), 11);
  in<QPushButton>(dialog, "choose font").click();
  EXPECT_EQ(rememberedFont(), FontChoice()) << "not before it is accepted";
  dialog.accept();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  EXPECT_EQ(rememberedLanguage(), QStringLiteral("zh_CN"));
  EXPECT_EQ(rememberedTheme(), Theme::Dark);
  EXPECT_TRUE(hasTone());
  EXPECT_EQ(rememberedReportChoice().paper.size, QPageSize::Letter);
  EXPECT_EQ(rememberedReportChoice().language, QStringLiteral("en"));
  EXPECT_EQ(rememberedFont(), (FontChoice{QStringLiteral("DejaVu Serif"), 11}));
  PreferencesDialog again(dialogs);
  in<QPushButton>(again, "desktop font").click();
  again.accept();
  EXPECT_EQ(rememberedFont(), FontChoice());
  EXPECT_EQ(rememberedLanguage(), QStringLiteral("zh_CN"));
}

TEST_F(PreferencesTest, KeepsNothingThatIsCancelled) {
  const Session usual = templateSession();
  PreferencesDialog dialog(dialogs);
  choose(in<QComboBox>(dialog, "paper"), QPageSize::Letter);
  type(dialog, "report.laboratory", "Laboratory A");
  dialog.reject();
  EXPECT_EQ(rememberedReportChoice(), ReportChoice());
  EXPECT_EQ(templateSession(), usual);
}

TEST_F(PreferencesTest, NewSessionsStartWithItsEntriesAndOpenOnesKeepTheirs) {
  OpenWindow open;
  open->document().startWith(paperSession());
  PreferencesDialog dialog(dialogs);
  type(dialog, "report.laboratory", "Laboratory A, Riverside");
  type(dialog, "instrument.sigma_horizontal_arcsec", "1,5");
  const QTemporaryDir folder;
  dialogs.protocolPath = folder.filePath(QStringLiteral("own.alidade-protocol"));
  QFile file(dialogs.protocolPath);
  ASSERT_TRUE(file.open(QFile::WriteOnly));
  file.write(QByteArray::fromStdString(writeProtocol(*templateNamed("there-and-back"))));
  file.close();
  in<QPushButton>(dialog, "load protocol").click();
  dialog.accept();
  EXPECT_EQ(open->document().session(), paperSession());
  ASSERT_TRUE(open->files().startNew());
  const Session& session = open->document().session();
  EXPECT_EQ(session.report.laboratory, "Laboratory A, Riverside");
  EXPECT_EQ(session.instrument.sigmaHorizontalArcsec, "1.5");
  EXPECT_EQ(session.instrument.sigmaVerticalArcsec, "2");
  const auto protocol = protocolOf(session);
  EXPECT_TRUE(protocol && *protocol);
  EXPECT_FALSE(open->document().isModified());
  PreferencesDialog again(dialogs);
  EXPECT_EQ(in<QLineEdit>(again, "report.laboratory").text(), QStringLiteral("Laboratory A, Riverside"));
  in<QPushButton>(again, "no protocol").click();
  again.accept();
  ASSERT_TRUE(open->files().startNew());
  EXPECT_TRUE(open->document().session().protocol.empty());
}

TEST_F(PreferencesTest, LeadsToAnEntryThatNoSessionCanUse) {
  const Session usual = templateSession();
  PreferencesDialog dialog(dialogs);
  type(dialog, "instrument.sigma_zero_arcsec", "two");
  dialog.accept();
  EXPECT_NE(dialog.result(), QDialog::Accepted);
  EXPECT_EQ(dialog.findChild<QTabWidget*>()->currentIndex(), 1);
  EXPECT_EQ(templateSession(), usual);
}

TEST_F(PreferencesTest, NewSessionsFollowAProtocolUntilNoneIsChosen) {
  Session usual = templateSession();
  const auto protocol = protocolOf(usual);
  ASSERT_TRUE(protocol && *protocol);
  EXPECT_EQ(protocolInWords(**protocol), "17 places, one face, there only");
  for (const ProtocolPlace& place : (*protocol)->places)
    EXPECT_FALSE(nominalPlace(place)) << "where the places of another device lie is not known";
  usual.protocol.clear();
  EXPECT_EQ(usual, blankSession());
  PreferencesDialog dialog(dialogs);
  in<QPushButton>(dialog, "no protocol").click();
  dialog.accept();
  EXPECT_EQ(templateSession(), blankSession());
}

TEST_F(PreferencesTest, AnUnreadableTemplateIsTheUsualOne) {
  const Session usual = templateSession();
  QSettings().setValue(QStringLiteral("newSession"), QByteArray("{\"format\": \"other\"}"));
  EXPECT_EQ(templateSession(), usual);
}

TEST_F(PreferencesTest, AreTheOneEntryOfTheMenus) {
  OpenWindow open;
  QStringList texts;
  for (const QAction* top : open->menuBar()->actions())
    for (const QAction* action : top->menu()->actions()) {
      texts.append(action->text().remove(u'&'));
      if (texts.last() == QStringLiteral("Preferences…")) {
        EXPECT_EQ(action->shortcut(), QKeySequence(QStringLiteral("Ctrl+,")));
      }
    }
  EXPECT_EQ(texts.count(QStringLiteral("Preferences…")), 1);
  for (const char* moved : {"Language", "Font", "Dark", "Page Setup…", "Tone for Unexpected Readings"})
    EXPECT_FALSE(texts.contains(QString::fromUtf8(moved))) << moved;
}

}  // namespace
}  // namespace alidade::ui
