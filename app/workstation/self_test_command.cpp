#include "app/workstation/self_test_command.h"

#include <QTextStream>

#include "core/base/failure.h"
#include "core/self_test/self_test_words.h"
#include "ui/self_test/installation_check.h"
#include "ui/text/visible_text.h"

namespace alidade {

namespace {

int checkAndWrite(const QString& path) {
  const ui::InstallationCheck check = ui::checkInstallation();
  const auto written = ui::writeInstallationCheck(check, path, {});
  if (!written) {
    QTextStream(stderr) << ui::visibleLine(path) << ": " << ui::visibleLine(written.problem().text()) << '\n';
    return 2;
  }
  QTextStream(stdout) << ui::visibleLine(verdictSentence(check.test)) << '\n';
  return check.test.hasPassed() ? 0 : 1;
}

}  // namespace

int writeSelfTest(const QString& path) {
  int exitCode = 1;
  const auto failure = failureOf([&] { exitCode = checkAndWrite(path); });
  if (failure) QTextStream(stderr) << "alidade: The check failed: " << ui::visibleLine(*failure) << ".\n";
  return exitCode;
}

}  // namespace alidade
