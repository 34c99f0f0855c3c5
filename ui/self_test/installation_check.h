#pragma once

#include <QDateTime>
#include <QString>
#include <memory>

#include "core/base/result.h"
#include "core/self_test/self_test.h"
#include "ui/report/report_paper.h"

class QPagedPaintDevice;

namespace alidade::ui {

/// The result of the self-test of the core and of the window, with its time.
struct InstallationCheck {
  SelfTest test;
  QDateTime at;

  QString product() const;  ///< "Alidade 0.1.0"
};
using SharedInstallationCheck = std::shared_ptr<const InstallationCheck>;

/// Checks this program, in the window's thread; takes a second.
InstallationCheck checkInstallation();

/// Adds the checks of the window to `ofCore`, the checks of the core, which any thread may make.
InstallationCheck checkInstallation(SelfTest ofCore);

/// Paints the check for paper: program, machine and libraries, all lines, the verdict. False: painting
/// failed.
bool paintInstallationCheck(QPagedPaintDevice& device, const InstallationCheck& check,
                            const ReportPaper& paper = {});

/// Writes a PDF/A-3b with the check as JSON attached. Returns the path, or why writing failed, for example
/// because `path` is one of `inputs`.
Result<QString> writeInstallationCheck(const InstallationCheck& check, const QString& path,
                                       const QStringList& inputs, const ReportPaper& paper = {});

}  // namespace alidade::ui
