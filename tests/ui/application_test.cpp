#include "ui/application.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QProcess>
#include <QTimer>
#include <stdexcept>

#include "tests/ui/support.h"
#include "ui/main_window.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;

TEST(Application, OutlivesWhatIsThrownInAnEventAndTellsOfItOnce) {
  auto* application = qobject_cast<Application*>(QCoreApplication::instance());
  ASSERT_TRUE(application);
  QStringList reported;
  QObject context;
  QObject::connect(application, &Application::failed, &context,
                   [&](const QString& reason) { reported.append(reason); });
  int thrown = 0;
  for (const char* reason : {"one", "another", "one", "one", "another"})
    QTimer::singleShot(0, &context, [&thrown, reason] {
      ++thrown;
      throw std::runtime_error(reason);
    });
  ASSERT_TRUE(waitFor([&] { return thrown == 5 && reported.size() == 2; }));
  QCoreApplication::processEvents();
  EXPECT_EQ(reported, (QStringList{QStringLiteral("a fault in the program (one)"),
                                   QStringLiteral("a fault in the program (another)")}));
}

TEST(Application, LeavesTheWindowAndWhatWasTyped) {
  OpenWindow open;
  QObject::connect(qobject_cast<Application*>(QCoreApplication::instance()), &Application::failed,
                   open.window.get(), &MainWindow::reportFailure);
  QTimer::singleShot(0, open.window.get(), [] { throw std::runtime_error("in the window"); });
  ASSERT_TRUE(waitFor([&] { return !open.dialogs->problems.isEmpty(); }));
  EXPECT_THAT(open.dialogs->problems.join(u'\n').toStdString(),
              HasSubstr("The window failed: a fault in the program (in the window)."));
  open->files().open(samplePath(QStringLiteral("paper-table-1.alidade")));
  open.waitUntilIdle();
  EXPECT_EQ(open->document().session(), paperSession());
}

/// Qt cannot represent a file name that is not UTF-8, and would create and open another file.
TEST(Application, NamesAFileWhoseNameIsNoUtf8) {
  QProcess program;
  program.start(
      QStringLiteral("sh"),
      {QStringLiteral("-c"), QStringLiteral("exec \"$0\" --report r.pdf \"$(printf 'm\\374.alidade')\""),
       QStringLiteral(ALIDADE_PROGRAM)});
  ASSERT_TRUE(program.waitForFinished());
  EXPECT_EQ(program.exitCode(), 2);
  EXPECT_EQ(program.readAllStandardError().toStdString(),
            "alidade: m\\xfc.alidade: a name that is no UTF-8 cannot be opened here: rename the file, or use "
            "alidade-cli\n");
}

}  // namespace
}  // namespace alidade::ui
