#include "ui/import/import_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>

#include "core/base/sha256.h"
#include "core/session/session_file.h"
#include "tests/ui/shown_texts.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/import/import_files.h"
#include "ui/main_window.h"

// The import page: files, positions, units, columns, zeros, and the target of the readings.

namespace alidade::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

const QByteArray gsi =
    "110001+00000001 21.322+37985926 22.322+09808000 31..00+00002405\n"
    "110002+00000002 21.322+37937060 22.322+09632500\n";

class ImportPageTest : public ::testing::Test {
 protected:
  ImportPageTest() { QSettings().remove(QStringLiteral("import")); }

  QString file(const QString& name, const QByteArray& content) const {
    const QString path = folder.filePath(name);
    QFile out(path);
    EXPECT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(content);
    return path;
  }
  const Session& session() { return open->document().session(); }

  /// Acts on the page once it shows the proposals; `act` may also inspect it.
  void choose(std::function<void(ImportPage&)> act) { open.dialogs->onImport = std::move(act); }

  static void waitUntilIdle(ImportPage& page) {
    ASSERT_TRUE(waitFor([&page] { return page.isUpToDate(); }));
  }
  static QString textOf(const ImportPage& page, const char* name) {
    if (const auto* text = page.findChild<QPlainTextEdit*>(QString::fromLatin1(name)))
      return text->toPlainText();
    return page.findChild<QLabel*>(QString::fromLatin1(name))->text();
  }
  static QComboBox* box(const ImportPage& page, const char* name) {
    return page.findChild<QComboBox*>(QString::fromLatin1(name));
  }
  static void pick(QComboBox* box, const QString& text) {
    const int at = box->findText(text);
    ASSERT_GE(at, 0) << text.toStdString();
    box->setCurrentIndex(at);
  }
  static QComboBox* whereOf(const ImportPage& page, int row) {
    return qobject_cast<QComboBox*>(page.findChild<ImportFiles*>()->cellWidget(row, 2));
  }
  static QComboBox* roundOf(const ImportPage& page, int row) {
    return qobject_cast<QComboBox*>(page.findChild<ImportFiles*>()->cellWidget(row, 4));
  }
  static bool mayImport(const ImportPage& page) {
    return page.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled();
  }
  static const QAbstractItemModel& preview(const ImportPage& page) {
    return *page.findChild<QTableView*>(QStringLiteral("import preview"))->model();
  }

  QTemporaryDir folder;
  OpenWindow open;
};

TEST_F(ImportPageTest, AsksForThePositionThatTheFileDoesNotSay) {
  choose([](ImportPage& page) {
    EXPECT_FALSE(mayImport(page));
    EXPECT_THAT(page.obstacle().toStdString(),
                HasSubstr("“arc.gsi” does not state the position it was read at"));
    EXPECT_EQ(textOf(page, "import summary"), page.obstacle());
  });
  EXPECT_FALSE(open->files().open(file(QStringLiteral("arc.gsi"), gsi)));
  EXPECT_TRUE(session().positions[0].readings.empty()) << "nothing was imported";

  choose([](ImportPage& page) {
    pick(whereOf(page, 0), QStringLiteral("All at 180°"));
    waitUntilIdle(page);
    EXPECT_TRUE(mayImport(page));
    EXPECT_THAT(textOf(page, "import summary").toStdString(), HasSubstr("2 rows of readings"));
    EXPECT_EQ(preview(page).index(1, 0).data().toString(), QStringLiteral("180°"));
    EXPECT_EQ(preview(page).index(1, 1).data().toString(), QStringLiteral("2")) << "the line of the file";
    EXPECT_THAT(preview(page).index(0, 6).data().toString().toStdString(), HasSubstr("341°52′"))
        << "normalised";
  });
  EXPECT_TRUE(open->files().open(file(QStringLiteral("arc.gsi"), gsi)));
  ASSERT_EQ(session().positions.size(), 1u);
  EXPECT_EQ(session().positions[0].axisDeg, "180");
  EXPECT_EQ(session().positions[0].readings.size(), 2u);
}

TEST_F(ImportPageTest, TakesFilesOfTwoPositionsByTheirNames) {
  open.dialogs->importPath =
      file(QStringLiteral("arc 0.gsi"), gsi) + u'\n' + file(QStringLiteral("arc 180.gsi"), gsi);
  choose([](ImportPage& page) {
    EXPECT_EQ(whereOf(page, 0)->currentText(), QStringLiteral("All at 0°"));
    EXPECT_EQ(whereOf(page, 1)->currentText(), QStringLiteral("All at 180°"));
    pick(roundOf(page, 1), QStringLiteral("2"));
  });
  EXPECT_TRUE(open->files().importReadings());
  ASSERT_EQ(session().positions.size(), 2u);
  EXPECT_EQ(session().positions[1].readings.at(0).round, "2");
  ASSERT_EQ(session().journal.size(), 2u);
  EXPECT_EQ(session().journal[1].why, journal_reasons::imported);
  EXPECT_THAT(session().journal[1].to, HasSubstr("“arc 180.gsi”, lines 1–2: 2 rows from row 1 on; SHA-256 " +
                                                 sha256(gsi.toStdString())));
  EXPECT_FALSE(firstBrokenEntry(session().journal));
}

TEST_F(ImportPageTest, TurnsTheAxisAtALine) {
  choose([](ImportPage& page) {
    pick(whereOf(page, 0), QStringLiteral("0°, then 180°"));
    auto* turned = page.findChild<ImportFiles*>()->cellWidget(0, 3)->findChild<QSpinBox*>();
    EXPECT_TRUE(turned->isVisible());
    turned->setValue(2);
  });
  EXPECT_TRUE(open->files().open(file(QStringLiteral("arc.gsi"), gsi)));
  ASSERT_EQ(session().positions.size(), 2u);
  EXPECT_EQ(session().positions[0].readings.size(), 1u);
  EXPECT_EQ(session().positions[1].readings.size(), 1u);
}

TEST_F(ImportPageTest, AsksOnceForTheUnitOfATable) {
  QByteArray table = "axis;point;Hz;V\n";
  for (int i = 1; i <= 30; ++i)
    table += "0;" + QByteArray::number(i) + ";341.52" + QByteArray::number(10 + i) + ";88.1649\n";
  choose([](ImportPage& page) {
    EXPECT_THAT(page.obstacle().toStdString(), HasSubstr("does not state the unit of its angles"));
    EXPECT_EQ(textOf(page, "import problems"), QString()) << "one question, no advice for each line";
    pick(box(page, "import unit"), QStringLiteral("Degrees.minutes seconds"));
    waitUntilIdle(page);
    EXPECT_EQ(textOf(page, "import problems"), QString());
    EXPECT_TRUE(mayImport(page));
  });
  EXPECT_TRUE(open->files().open(file(QStringLiteral("arc.csv"), table)));
  EXPECT_EQ(session().positions.at(0).readings.at(0).horizontal, "341 52 11");
  EXPECT_EQ(open.dialogs->importsAsked, 1);
  EXPECT_TRUE(open.dialogs->problems.isEmpty());
}

TEST_F(ImportPageTest, ProposesTheUnitOfTheInstrument) {
  changeField(open->document(), {.field = "instrument.angle_unit"}, "degrees");
  choose([](ImportPage& page) {
    EXPECT_EQ(box(page, "import unit")->currentText(), QStringLiteral("Decimal degrees"));
    waitUntilIdle(page);
    EXPECT_EQ(preview(page).index(0, 6).data().toString(), QStringLiteral("341.5224°"));
    page.findChild<QLineEdit*>(QStringLiteral("import zero 0° h"))->setText(QStringLiteral("332.5"));
    page.findChild<QLineEdit*>(QStringLiteral("import zero 0° v"))->setText(QStringLiteral("89.9"));
    EXPECT_TRUE(mayImport(page));
  });
  EXPECT_TRUE(open->files().open(file(QStringLiteral("a.csv"), "axis;Hz;V\n0;341.5224;88.1649\n")));
  EXPECT_EQ(session().positions.at(0).zero.horizontal, "332.5°");
}

TEST_F(ImportPageTest, ProposesGonWhereNumbersSaySo) {
  choose([](ImportPage& page) {
    EXPECT_EQ(box(page, "import unit")->currentText(), QStringLiteral("Gon"));
    EXPECT_TRUE(mayImport(page));
  });
  EXPECT_TRUE(
      open->files().open(file(QStringLiteral("a.csv"), "axis;Hz;V\n0;379,8592;98,0811\n0;12,5;97,54\n")));
  EXPECT_EQ(session().positions.at(0).readings.at(0).horizontal, "379,8592gon");
}

TEST_F(ImportPageTest, RemembersHowALayoutWasTaken) {
  const QByteArray table = "a,b,c\n1,341.5224,88.1649\n2,341.2601,86.4124\n";
  choose([](ImportPage& page) {
    EXPECT_THAT(page.obstacle().toStdString(), HasSubstr("Choose the columns"));
    pick(box(page, "import point"), QStringLiteral("1: a"));
    pick(box(page, "import horizontal"), QStringLiteral("2: b"));
    pick(box(page, "import vertical"), QStringLiteral("3: c"));
    pick(box(page, "import unit"), QStringLiteral("Degrees.minutes seconds"));
    pick(whereOf(page, 0), QStringLiteral("All at 0°"));
  });
  ASSERT_TRUE(open->files().open(file(QStringLiteral("first.csv"), table)));
  ASSERT_EQ(session().positions.at(0).readings.size(), 2u);
  EXPECT_EQ(session().positions[0].readings[0].vertical, "88 16 49");

  choose([](ImportPage& page) {
    EXPECT_EQ(box(page, "import horizontal")->currentText(), QStringLiteral("2: b"));
    EXPECT_EQ(box(page, "import unit")->currentText(), QStringLiteral("Degrees.minutes seconds"));
    pick(whereOf(page, 0), QStringLiteral("All at 180°"));
  });
  EXPECT_TRUE(open->files().open(file(QStringLiteral("second.csv"), "a,b,c\n7,341.0000,91.0000\n")));
  EXPECT_EQ(session().positions.back().readings.back().horizontal, "341 00 00");
}

// The choice for one file is not applied to another whose numbers contradict it.
TEST_F(ImportPageTest, RemembersNoUnitAgainstTheNumbers) {
  const auto tableOf = [](const QByteArray& row) { return "axis;Hz;V\n0;" + row + "\n"; };
  choose([](ImportPage& page) { pick(box(page, "import unit"), QStringLiteral("Degrees.minutes seconds")); });
  ASSERT_TRUE(open->files().open(file(QStringLiteral("a.csv"), tableOf("341.5224;88.1649"))));
  choose([](ImportPage& page) { EXPECT_EQ(box(page, "import unit")->currentText(), QStringLiteral("Gon")); });
  ASSERT_TRUE(open->files().open(file(QStringLiteral("b.csv"), tableOf("379.8592;98.0811"))));
  EXPECT_EQ(session().positions.at(0).readings.back().vertical, "98.0811gon");
}

TEST_F(ImportPageTest, TellsThatAFileWasImportedBefore) {
  const QString path = file(QStringLiteral("arc 0.gsi"), gsi);
  ASSERT_TRUE(open->files().open(path));
  choose([](ImportPage& page) {
    EXPECT_THAT(textOf(page, "import problems").toStdString(),
                HasSubstr("“arc 0.gsi” was imported into this session before."));
  });
  EXPECT_TRUE(open->files().open(path));
  EXPECT_EQ(session().positions.at(0).readings.back().round, "2") << "further rounds of the same position";
}

TEST_F(ImportPageTest, MovesAColumnThatIsChosenForSomethingElse) {
  choose([](ImportPage& page) {
    EXPECT_EQ(box(page, "import horizontal")->currentText(), QStringLiteral("2: Hz"));
    pick(box(page, "import horizontal"), QStringLiteral("3: V"));
    EXPECT_EQ(box(page, "import vertical")->currentText(), QStringLiteral("none"));
    waitUntilIdle(page);
    EXPECT_FALSE(mayImport(page));
    pick(box(page, "import vertical"), QStringLiteral("2: Hz"));
  });
  EXPECT_TRUE(open->files().open(file(QStringLiteral("a.csv"), "axis,Hz,V\n0,88°,341°\n")));
  EXPECT_EQ(session().positions.at(0).readings.at(0).horizontal, "341°");
}

TEST_F(ImportPageTest, AddsToTheReadingsThereAndIsUndoneInOneStep) {
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  const Session before = session();
  choose([](ImportPage& page) {
    EXPECT_TRUE(page.findChild<QRadioButton*>(QStringLiteral("import add"))->isChecked());
    pick(whereOf(page, 0), QStringLiteral("All at 0°"));
    pick(roundOf(page, 0), QStringLiteral("2"));
  });
  ASSERT_TRUE(open->files().open(file(QStringLiteral("arc.gsi"), gsi)));
  EXPECT_EQ(open.dialogs->saveQuestions, 0);
  EXPECT_THAT(open->document().path().toStdString(), HasSubstr("paper-table-1.alidade"))
      << "the same session";
  EXPECT_EQ(session().positions[0].readings.size(), before.positions[0].readings.size() + 2);
  EXPECT_EQ(session().title, before.title);
  ASSERT_EQ(session().journal.size(), before.journal.size() + 1);
  EXPECT_THAT(session().journal.back().to, HasSubstr("2 rows from row 18 on"));
  EXPECT_TRUE(open->document().isModified());
  const Session after = session();
  open.waitUntilIdle();
  open->undo();
  EXPECT_EQ(session(), before);
  EXPECT_FALSE(open->document().isModified());
  open->redo();
  EXPECT_EQ(session().positions, after.positions);
  EXPECT_EQ(session().journal.size(), after.journal.size());
}

TEST_F(ImportPageTest, TellsOfAnUndoThatCameAfterSaving) {
  choose([](ImportPage& page) { pick(whereOf(page, 0), QStringLiteral("All at 0°")); });
  ASSERT_TRUE(open->files().open(file(QStringLiteral("arc.gsi"), gsi)));
  ASSERT_FALSE(open->document().save(folder.filePath(QStringLiteral("s.alidade"))));
  open->undo();
  ASSERT_EQ(session().journal.size(), 2u);
  EXPECT_EQ(session().journal[1].why, journal_reasons::undone);
  EXPECT_THAT(session().journal[1].from, HasSubstr("arc.gsi"));
}

TEST_F(ImportPageTest, LeavesEverythingWhereItIsCancelled) {
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  const Session before = session();
  ImportPage page({.sources = *readSources({file(QStringLiteral("arc 0.gsi"), gsi)}),
                   .session = std::make_shared<const Session>(before)});
  page.show();
  waitUntilIdle(page);
  EXPECT_TRUE(mayImport(page));
  QTest::keyClick(&page, Qt::Key_Escape);
  EXPECT_EQ(page.result(), QDialog::Rejected);
  EXPECT_FALSE(page.isVisible());
  EXPECT_EQ(session(), before);
  EXPECT_FALSE(open->document().undoStack().canUndo());
}

TEST_F(ImportPageTest, TakesTypedZerosWhereTheFileHasNone) {
  choose([](ImportPage& page) {
    pick(whereOf(page, 0), QStringLiteral("All at 0°"));
    waitUntilIdle(page);
    auto* horizontal = page.findChild<QLineEdit*>(QStringLiteral("import zero 0° h"));
    auto* vertical = page.findChild<QLineEdit*>(QStringLiteral("import zero 0° v"));
    ASSERT_TRUE(horizontal && vertical);
    horizontal->setText(QStringLiteral("332 32 54"));
    EXPECT_FALSE(mayImport(page)) << "half a zero is none";
    vertical->setText(QStringLiteral("89 71 57"));
    EXPECT_THAT(page.obstacle().toStdString(), HasSubstr("has 71 minutes"));
    vertical->setText(QStringLiteral("89 59 57"));
    EXPECT_TRUE(mayImport(page));
  });
  ASSERT_TRUE(open->files().open(file(QStringLiteral("arc.gsi"), gsi)));
  EXPECT_EQ(session().positions.at(0).zero.horizontal, "332 32 54");
  EXPECT_EQ(session().positions.at(0).zero.vertical, "89 59 57");
}

TEST_F(ImportPageTest, ShowsTheZerosOfTheFile) {
  choose([](ImportPage& page) {
    auto* horizontal = page.findChild<QLineEdit*>(QStringLiteral("import zero 0° h"));
    ASSERT_TRUE(horizontal);
    EXPECT_TRUE(horizontal->isReadOnly());
    EXPECT_EQ(horizontal->text(), QStringLiteral("332°32′54″"));
    page.findChild<QLineEdit*>(QStringLiteral("import zero point"))->setText(QStringLiteral("ref"));
    waitUntilIdle(page);
    EXPECT_FALSE(horizontal->isReadOnly()) << "the zero is another point now";
  });
  EXPECT_TRUE(open->files().open(
      file(QStringLiteral("a.csv"),
           "axis,point,Hz,V\n0,zero,332°32'54\",89°59'57\"\n0,1,341°52'24\",88°16'49\"\n")));
  EXPECT_EQ(session().positions.at(0).readings.size(), 2u);
}

TEST_F(ImportPageTest, TellsWhatCannotBeReadByItsKinds) {
  QByteArray odd = gsi + "110002+00000003 21.324+34171260 22.324+08641240\n";
  for (int i = 0; i < 50; ++i) odd += "21.3o4+" + QByteArray::number(i) + "\n";
  choose([](ImportPage& page) {
    pick(whereOf(page, 0), QStringLiteral("All at 0°"));
    waitUntilIdle(page);
    const std::string shownProblems = textOf(page, "import problems").toStdString();
    EXPECT_THAT(shownProblems, HasSubstr("Line 4, column 1: “21.3o4+0” is no GSI word"));
    EXPECT_THAT(shownProblems, HasSubstr("(and 49 more of this kind)"));
    EXPECT_THAT(shownProblems, HasSubstr("has 71 minutes"));
    EXPECT_LE(textOf(page, "import problems").count(u'\n'), 4);
    EXPECT_THAT(textOf(page, "import summary").toStdString(),
                HasSubstr("3 rows of readings; 51 entries or lines"));
    const QModelIndex bad = preview(page).index(2, 6);
    EXPECT_THAT(bad.data(Qt::ToolTipRole).toString().toStdString(), HasSubstr("71 minutes"));
  });
  EXPECT_TRUE(open->files().open(file(QStringLiteral("arc.gsi"), odd)));
  EXPECT_EQ(session().positions.at(0).readings.at(2).horizontal, "341°71'26.0\"") << "kept as it stands";
}

TEST_F(ImportPageTest, ReadsTheClipboard) {
  QApplication::clipboard()->setText(
      QStringLiteral("Position\tHz [gon]\tV [gon]\n0\t379,8592\t98,0811\n180\t379,9\t101,9\n"));
  QTest::keyClick(open.window.get(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(open.dialogs->importsAsked, 1);
  ASSERT_EQ(session().positions.size(), 2u);
  EXPECT_EQ(session().positions[1].readings.at(0).vertical, "101,9gon");
  EXPECT_THAT(session().journal.back().to, HasSubstr("“clipboard”, line 3"));
  QApplication::clipboard()->setText(QString());
  EXPECT_FALSE(open->files().importClipboard());
  EXPECT_EQ(open.dialogs->problems.size(), 1);
}

TEST_F(ImportPageTest, TakesAllFilesThatAreDropped) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file(QStringLiteral("a0 0.gsi"), gsi)),
                QUrl::fromLocalFile(file(QStringLiteral("a1 180.gsi"), gsi))});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(open.window.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(open.window.get(), &drop);
  EXPECT_EQ(open.dialogs->importsAsked, 1);
  EXPECT_EQ(session().positions.size(), 2u);
}

TEST_F(ImportPageTest, ReadsEveryFormatInOnePage) {
  const auto m5 = [](const QByteArray& numbers) {
    return "For M5|Adr 00001|PI1 " + QByteArray("3").rightJustified(27) + "|" + numbers;
  };
  open.dialogs->importPath =
      file(QStringLiteral("a 0.gsi"), gsi) + u'\n' +
      file(QStringLiteral("b 0.m5"),
           m5("                      |Hz        34.9078 gon |V1       106.3481 gon |\r\n")) +
      u'\n' +
      file(QStringLiteral("c 180.sdr"),
           QByteArray("00NMSDR33 V04-04.02     04-Oct-26 10:00 211111\r\n") + "09F1" +
               QByteArray("ST1").leftJustified(16) + QByteArray("4").leftJustified(16) + QByteArray(16, ' ') +
               QByteArray("101.2345").leftJustified(16) + QByteArray("87.4321").leftJustified(16) + "\r\n");
  EXPECT_TRUE(open->files().importReadings());
  ASSERT_EQ(session().positions.size(), 2u);
  EXPECT_EQ(session().positions[0].readings.size(), 3u);
  EXPECT_EQ(session().positions[1].readings.at(0).horizontal, "87.4321gon");
}

TEST_F(ImportPageTest, ShowsHostileNamesAsText) {
  const QString name = QStringLiteral("a\u202E<b>&amp;%1.csv");
  ImportPage page({.sources = *readSources(
                       {file(name, "Hz\u202E;V;<i>x</i>\n1\u2066;2;3\n341°52'24\";88°16'49\";<b>\n")}),
                   .session = std::make_shared<const Session>(blankSession())});
  page.show();
  waitUntilIdle(page);
  expectAllVisible(page, QStringLiteral("import page"));
}

TEST_F(ImportPageTest, NamesEveryFieldAndGivesEachALetter) {
  ImportPage page({.sources = *readSources({file(QStringLiteral("a.csv"), "axis,Hz,V\n0,341°,88°\n"),
                                            file(QStringLiteral("b.gsi"), gsi)}),
                   .session = std::make_shared<const Session>(paperSession())});
  page.show();
  waitUntilIdle(page);
  QStringList letters;
  for (const QLabel* label : page.findChildren<QLabel*>())
    if (label->buddy() && label->isVisible())
      letters.append(QKeySequence::mnemonic(label->text()).toString());
  for (const QAbstractButton* button : page.findChildren<QAbstractButton*>())
    if (button->isVisible()) letters.append(QKeySequence::mnemonic(button->text()).toString());
  letters.removeAll(QString());
  EXPECT_EQ(letters.size(), QSet<QString>(letters.begin(), letters.end()).size())
      << letters.join(u' ').toStdString();
  for (const QWidget* field : page.findChildren<QWidget*>()) {
    const bool isEntry = qobject_cast<const QComboBox*>(field) || qobject_cast<const QLineEdit*>(field);
    if (!isEntry || !field->isVisible() || qobject_cast<QAbstractSpinBox*>(field->parentWidget())) continue;
    bool isNamed = !field->accessibleName().isEmpty();
    for (const QLabel* label : page.findChildren<QLabel*>()) isNamed = isNamed || label->buddy() == field;
    EXPECT_TRUE(isNamed) << field->objectName().toStdString();
  }
}

}  // namespace
}  // namespace alidade::ui
