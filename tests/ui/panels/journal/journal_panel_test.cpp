#include "ui/panels/journal/journal_panel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLabel>
#include <QTabWidget>
#include <QTemporaryDir>

#include "tests/ui/report/printed.h"
#include "tests/ui/support.h"
#include "ui/commands/edit_readings.h"
#include "ui/dialogs/file_flow.h"
#include "ui/main_window.h"
#include "ui/models/readings_model.h"
#include "ui/panels/parts/data_table.h"
#include "ui/panels/readings/readings_table.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;

struct JournalBench {
  OpenWindow open;
  QTemporaryDir folder;

  JournalBench() {
    open->document().startWith(paperSession());
    open.waitUntilIdle();
  }

  void change() {
    ReadingsEditor(open->document(), 0).setCell({3, ReadingColumn::Vertical}, "83 50 35");
    open.waitUntilIdle();
  }
  QString cell(int role) {
    return open->currentTable()
        ->model()
        ->index(3, static_cast<int>(ReadingColumn::Vertical))
        .data(role)
        .toString();
  }
  QTabWidget& pages() {
    return *qobject_cast<QTabWidget*>(open->findChild<JournalPanel*>()->parentWidget()->parentWidget());
  }
  bool hasPage() { return pages().isTabVisible(pages().indexOf(open->findChild<JournalPanel*>())); }
  std::string summary() {
    pages().setCurrentWidget(open->findChild<JournalPanel*>());
    return open->findChild<QLabel*>(QStringLiteral("journal summary"))->text().toStdString();
  }
  QString tableCell(int row, int column) {
    const auto* model = open->findChild<JournalPanel*>()->findChild<DataTable*>()->model();
    return model->index(row, column).data().toString();
  }
};

TEST(JournalPage, IsThereOnceAReadingThatStoodWasChanged) {
  JournalBench bench;
  EXPECT_FALSE(bench.hasPage());
  bench.change();
  EXPECT_TRUE(bench.hasPage());
  EXPECT_EQ(bench.summary(), "One reading was changed after entry.");
  EXPECT_EQ(bench.tableCell(0, 1).toStdString(), "0°, row 4 (point 4), vertical reading");
  EXPECT_EQ(bench.tableCell(0, 2).toStdString(), paperSession().positions[0].readings[3].vertical);
  EXPECT_EQ(bench.tableCell(0, 3).toStdString(), "83 50 35");
  EXPECT_EQ(bench.tableCell(0, 4).toStdString(), "retyped");
  bench.open->undo();
  bench.open.waitUntilIdle();
  EXPECT_FALSE(bench.hasPage());
}

TEST(JournalPage, CellsTellOfTheirFirstText) {
  JournalBench bench;
  EXPECT_EQ(bench.cell(ReadingsModel::ChangedRole), QStringLiteral("false"));
  bench.change();
  EXPECT_EQ(bench.cell(ReadingsModel::ChangedRole), QStringLiteral("true"));
  EXPECT_THAT(
      bench.cell(Qt::ToolTipRole).toStdString(),
      HasSubstr("First entered as " + paperSession().positions[0].readings[3].vertical + "; retyped, "));
}

TEST(JournalPage, SealingSavesAndTellsOfLaterChanges) {
  JournalBench bench;
  bench.open.dialogs->savePath = bench.folder.filePath(QStringLiteral("s.alidade"));
  EXPECT_FALSE(bench.open->files().seal()) << "nobody seals it";
  EXPECT_TRUE(bench.open->document().session().journal.empty());
  bench.open.dialogs->sealedBy = QStringLiteral("R. Roe");
  EXPECT_TRUE(bench.open->files().seal());
  bench.open.waitUntilIdle();
  EXPECT_FALSE(bench.open->document().isModified());
  EXPECT_THAT(bench.summary(), HasSubstr(" UTC by R. Roe and unchanged since."));
  bench.change();
  EXPECT_THAT(bench.summary(), HasSubstr("one change since: the current revision is not sealed."));
}

TEST(JournalPage, IsPrinted) {
  JournalBench bench;
  EXPECT_TRUE(
      Printed(paperSession()).contains("Corrections none; no entry was changed after it was recorded"));
  bench.change();
  const Printed printed(bench.open->document().session());
  EXPECT_TRUE(printed.contains("One reading was changed after entry. One entry in the journal, see below."));
  const std::string first = paperSession().positions[0].readings[3].vertical;
  EXPECT_TRUE(printed.contains(("vertical reading first entered as " + first).c_str()));
  EXPECT_TRUE(printed.contains("Journal of changes"));
  EXPECT_TRUE(printed.contains(("retyped " + first + " 83 50 35").c_str()));
}

}  // namespace
}  // namespace alidade::ui
