#include "ui/self_test/installation_dialog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTreeWidget>

#include "tests/ui/language/speaking.h"
#include "tests/ui/support.h"
#include "ui/self_test/window_checks.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

TEST(InstallationCheck, TheWindowHasWhatItNeeds) {
  const Speaking english(QStringLiteral("en"));
  const std::vector<SelfCheck> checks = windowChecks();
  EXPECT_GE(checks.size(), 12U + 24U + 2U + 3U);  // samples, pages of the guide, languages, fonts
  for (const SelfCheck& check : checks)
    EXPECT_NE(check.outcome, SelfCheck::Outcome::Failed) << check.name << ": " << check.found;
}

TEST(InstallationCheck, IsShownAndWritten) {
  const Speaking english(QStringLiteral("en"));
  const QTemporaryDir folder;
  ScriptedDialogs dialogs;
  InstallationDialog dialog(dialogs);
  ASSERT_TRUE(waitFor([&] { return dialog.last() != nullptr; }));
  EXPECT_THAT(dialog.verdict().toStdString(), HasSubstr("This installation passes: all "));
  EXPECT_EQ(dialog.findChild<QTreeWidget*>()->topLevelItemCount(), 8);
  dialogs.exportPath = folder.filePath(QStringLiteral("check.pdf"));
  EXPECT_TRUE(dialog.savePdf());
  EXPECT_TRUE(bytesOf(dialogs.exportPath).startsWith("%PDF-"));
  dialogs.printPath = folder.filePath(QStringLiteral("printed.pdf"));
  EXPECT_TRUE(dialog.print());
  EXPECT_TRUE(bytesOf(dialogs.printPath).startsWith("%PDF-"));
  EXPECT_EQ(dialogs.problems, QStringList());
  dialogs.exportPath = folder.filePath(QStringLiteral("no/such/check.pdf"));
  EXPECT_FALSE(dialog.savePdf());
  EXPECT_EQ(dialogs.problems.size(), 1);
}

TEST(InstallationCheck, TheProgramWritesItWithoutADisplay) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("check.pdf"));
  QProcess program;
  program.start(QStringLiteral(ALIDADE_PROGRAM), {QStringLiteral("--self-test"), path});
  ASSERT_TRUE(program.waitForFinished(60000));
  EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
  EXPECT_THAT(program.readAllStandardOutput().toStdString(), HasSubstr("This installation passes: all "));
  EXPECT_TRUE(bytesOf(path).startsWith("%PDF-"));
  program.start(QStringLiteral(ALIDADE_PROGRAM),
                {QStringLiteral("--self-test"), path, samplePath(QStringLiteral("two-faces"))});
  ASSERT_TRUE(program.waitForFinished(60000));
  EXPECT_EQ(program.exitCode(), 2);
}

}  // namespace
}  // namespace alidade::ui
