#include <gtest/gtest.h>

#include <QLineEdit>
#include <QTest>

#include "tests/ui/support.h"
#include "ui/main_window.h"
#include "ui/panels/readings/readings_table.h"

namespace alidade::ui {
namespace {

QStringList warnings;

void keepWarning(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type == QtWarningMsg) warnings.append(text);
}

// Escape closes the editor of a cell, which still exists until events are processed.
TEST(ClosedEditor, IsNotHandedInByWhatUsesTheSessionAtOnce) {
  OpenWindow open;
  open->files().open(samplePath(QStringLiteral("paper-table-1.alidade")));
  open.waitUntilIdle();
  open->currentTable()->selectCell(3, ReadingColumn::Vertical);
  typeInto(*open->currentTable(), QStringLiteral("12"), Qt::Key_Escape);
  warnings.clear();
  const QtMessageHandler before = qInstallMessageHandler(keepWarning);
  open->commitPending();
  qInstallMessageHandler(before);
  EXPECT_EQ(warnings, QStringList());
  EXPECT_EQ(open->document().session(), paperSession());
}

}  // namespace
}  // namespace alidade::ui
