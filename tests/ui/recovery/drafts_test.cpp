#include "ui/recovery/drafts.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include "core/simulation/protocol.h"
#include "tests/ui/support.h"
#include "ui/dialogs/protocol_dialog.h"
#include "ui/dialogs/report_dialog.h"
#include "ui/import/import_page.h"
#include "ui/import/import_source.h"
#include "ui/instrument/check_input.h"
#include "ui/instrument/check_rows_table.h"
#include "ui/instrument/instrument_dialog.h"
#include "ui/panels/parts/cell_delegate.h"
#include "ui/text/entry_text.h"

// Typing in forms outside any session, and its recovery after a process was killed.

namespace alidade::ui {
namespace {

const QString anyForm = QStringLiteral("form");

QJsonObject textDraft(const QString& text) {
  return {{QStringLiteral("text"), text}};
}

/// Types into the current cell; the first key opens the editor.
void type(CheckRowsTable& table, const QString& text) {
  QTest::keyClicks(&table, text.left(1));
  QTest::keyClicks(static_cast<CellDelegate*>(table.itemDelegate())->openEditor(), text.mid(1));
}

class DraftsTest : public ::testing::Test {
 protected:
  DraftsTest() { drafts().keepIn(folder.path()); }
  ~DraftsTest() override { drafts().keepIn({}); }

  static QStringList files(const QString& in) {
    return QDir(in).entryList({QStringLiteral("*.drafts")}, QDir::Files);
  }

  /// Waits a second. From then on the drafts belong to a new process, which finds those of this killed one.
  void killAndStart() {
    QTest::qWait(1000);
    ASSERT_LT(kills, 9);
    const QString next = folder.filePath(QStringLiteral("start %1").arg(++kills));
    ASSERT_TRUE(QDir().mkpath(next));
    for (const QString& name : files(at))
      ASSERT_TRUE(QFile::copy(QDir(at).filePath(name), QDir(next).filePath(name)));
    drafts().keepIn(next);
    at = next;
  }

  QTemporaryDir folder;
  QString at = folder.path();
  int kills = 0;
};

TEST_F(DraftsTest, AreWrittenWithinASecondForTheirOwnerAlone) {
  EXPECT_TRUE(files(at).isEmpty());
  drafts().set(anyForm, textDraft(QStringLiteral("341 5")));
  QTest::qWait(1000);
  ASSERT_EQ(files(at).size(), 1);
  struct stat is = {};
  ASSERT_EQ(stat(QDir(at).filePath(files(at).first()).toLocal8Bit().constData(), &is), 0);
  EXPECT_EQ(is.st_mode & 0777U, 0600U);
  killAndStart();
  EXPECT_EQ(drafts().of(anyForm), textDraft(QStringLiteral("341 5")));
  drafts().set(anyForm, {});
  QTest::qWait(1000);
  EXPECT_TRUE(files(at).isEmpty()) << "given up, nothing is kept";
}

TEST_F(DraftsTest, AreWrittenAtOnceWhereTheProcessIsAboutToEnd) {
  drafts().set(anyForm, textDraft(QStringLiteral("341 5")));
  drafts().keepNow();
  EXPECT_EQ(files(at).size(), 1);
}

TEST_F(DraftsTest, OfTwoProcessesAreBothFound) {
  drafts().set(anyForm, textDraft(QStringLiteral("one")));
  {
    drafts().keepNow();
    Drafts other;
    other.keepIn(at);
    EXPECT_TRUE(other.of(anyForm).isEmpty()) << "a living process keeps its own";
    other.set(QStringLiteral("another form"), textDraft(QStringLiteral("two")));
    other.keepNow();
    EXPECT_EQ(files(at).size(), 2);
  }
  killAndStart();
  EXPECT_EQ(drafts().of(anyForm), textDraft(QStringLiteral("one")));
  EXPECT_EQ(drafts().of(QStringLiteral("another form")), textDraft(QStringLiteral("two")));
}

TEST_F(DraftsTest, OfOneFormInTwoProcessesWaitForEachOther) {
  drafts().set(anyForm, textDraft(QStringLiteral("one")));
  {
    Drafts other;
    other.keepIn(at);
    other.set(anyForm, textDraft(QStringLiteral("two")));
  }
  killAndStart();
  const QJsonObject first = drafts().of(anyForm);
  EXPECT_FALSE(first.isEmpty());
  drafts().set(anyForm, {});
  killAndStart();
  EXPECT_FALSE(drafts().of(anyForm).isEmpty());
  EXPECT_NE(drafts().of(anyForm), first);
}

TEST_F(DraftsTest, ThatCannotBeWrittenAreToldUntilTheyCan) {
  QStringList reported;
  QObject context;
  QObject::connect(&drafts(), &Drafts::troubled, &context,
                   [&reported](const QString& sentence) { reported.append(sentence); });
  ASSERT_TRUE(QDir(at).removeRecursively());
  drafts().set(anyForm, textDraft(QStringLiteral("341 5")));
  ASSERT_TRUE(waitFor([&reported] { return !reported.isEmpty(); }));
  EXPECT_THAT(reported.first().toStdString(), testing::HasSubstr("would be lost in a crash"));
  ASSERT_TRUE(QDir().mkpath(at));
  ASSERT_TRUE(waitFor([&reported] { return reported.last().isEmpty(); }));
  EXPECT_EQ(files(at).size(), 1);
}

TEST_F(DraftsTest, HoldRowsOfAnInstrumentCheckAndTheCellBeingTyped) {
  ScriptedDialogs dialogs;
  {
    InstrumentDialog dialog(dialogs);
    dialog.show();
    CheckRowsTable& table = dialog.input().table();
    table.setCurrentIndex(table.rows().index(0, 2));
    type(table, QStringLiteral("Pillar"));
    table.commitOpenEditor();
    table.setCurrentIndex(table.rows().index(0, 4));
    type(table, QStringLiteral("341 5"));
    killAndStart();
  }
  {
    InstrumentDialog dialog(dialogs);
    const CheckRowsModel& rows = dialog.input().table().rows();
    EXPECT_EQ(rows.index(0, 2).data().toString(), QStringLiteral("Pillar"));
    EXPECT_EQ(rows.index(0, 4).data().toString(), QStringLiteral("341 5"));
    auto* clear = dialog.findChild<QPushButton*>(QStringLiteral("clear check rows"));
    clear->click();
    EXPECT_TRUE(rows.isBlank());
    clear->click();
    EXPECT_EQ(rows.index(0, 4).data().toString(), QStringLiteral("341 5")) << "brought back";
    clear->click();
    killAndStart();
  }
  EXPECT_TRUE(InstrumentDialog(dialogs).input().table().rows().isBlank());
}

TEST_F(DraftsTest, HoldAProtocolBeingEdited) {
  const SightingProtocol protocol = *templateNamed("there-and-back");
  const auto entry = [](ProtocolDialog& dialog, int index) {
    return dialog.findChildren<QLineEdit*>().at(index);
  };
  {
    ProtocolDialog dialog(protocol, CircleUnit::Dms);
    entry(dialog, 0)->clear();
    QTest::keyClicks(entry(dialog, 0), QStringLiteral("Two gro"));
    dialog.findChild<QSpinBox*>()->setValue(7);
    killAndStart();
  }
  {
    ProtocolDialog dialog(protocol, CircleUnit::Dms);
    EXPECT_EQ(entry(dialog, 0)->text(), QStringLiteral("Two gro"));
    EXPECT_EQ(dialog.findChild<QSpinBox*>()->value(), 7);
    EXPECT_THAT(dialog.findChild<QLabel*>(QStringLiteral("protocol remark"))->text().toStdString(),
                testing::HasSubstr("Entries restored as they were when the program ended."));
    dialog.reject();
    killAndStart();
  }
  ProtocolDialog dialog(protocol, CircleUnit::Dms);
  EXPECT_EQ(entry(dialog, 0)->text(), qText(protocol.name)) << "given up";
}

TEST_F(DraftsTest, HoldThePointingZerosOfAnImportOfTheSameFile) {
  const auto page = [](const char* text) {
    const auto sources = textSource(QStringLiteral("table"), text);
    return std::make_unique<ImportPage>(
        ImportRequest{.sources = *sources, .session = std::make_shared<const Session>(blankSession())});
  };
  constexpr const char* table =
      "axis,point,horizontal,vertical\n0,1,341 52 24,88 16 49\n0,2,341 53 24,88 20 49\n";
  const auto zero = [](ImportPage& of) {
    return of.findChild<QLineEdit*>(QStringLiteral("import zero 0° h"));
  };
  {
    const auto open = page(table);
    ASSERT_TRUE(waitFor([&] { return open->isUpToDate() && zero(*open); }));
    QTest::keyClicks(zero(*open), QStringLiteral("341 5"));
    killAndStart();
  }
  {
    const auto other = page("axis,point,horizontal,vertical\n0,1,341 52 24,88 16 50\n");
    ASSERT_TRUE(waitFor([&] { return other->isUpToDate() && zero(*other); }));
    EXPECT_EQ(zero(*other)->text(), QString()) << "of another file";
  }
  const auto again = page(table);
  ASSERT_TRUE(waitFor([&] { return again->isUpToDate() && zero(*again); }));
  EXPECT_EQ(zero(*again)->text(), QStringLiteral("341 5"));
}

TEST_F(DraftsTest, HoldWhatIsChosenForAReport) {
  ReportQuestion question;
  const auto margin = [](ReportDialog& dialog) { return dialog.findChildren<QDoubleSpinBox*>().at(0); };
  {
    ReportDialog dialog(question);
    margin(dialog)->setValue(33);
    killAndStart();
  }
  ReportDialog dialog(question);
  EXPECT_EQ(margin(dialog)->value(), 33);
}

}  // namespace
}  // namespace alidade::ui
