#pragma once

#include <QDateTime>
#include <QString>
#include <memory>

#include "core/base/result.h"
#include "core/self_test/self_test.h"
#include "ui/report/report_paper.h"

class QPagedPaintDevice;

namespace alidade::ui {

/// The self-test of the core and of the window, at one time.
struct InstallationCheck {
  SelfTest test;
  QDateTime at;

  QString product() const;  ///< "Alidade 0.1.0"
};
using SharedInstallationCheck = std::shared_ptr<const InstallationCheck>;

/// Checks this program, in the window's thread; takes a second.
InstallationCheck checkInstallation();

/// The same with given lines of the core, which any thread may compute.
InstallationCheck checkInstallation(SelfTest ofCore);

/// Paints the check for paper: program, machine and libraries, all lines, the verdict. False: painting
/// failed.
bool paintInstallationCheck(QPagedPaintDevice& device, const InstallationCheck& check,
                            const ReportPaper& paper = {});

/// Writes a PDF/A-3b with the check as JSON attached. Returns the path, or why writing failed, for example if
/// it is one of `inputs`.
Result<QString> writeInstallationCheck(const InstallationCheck& check, const QString& path,
                                       const QStringList& inputs, const ReportPaper& paper = {});

}  // namespace alidade::ui
