#pragma once

#include <QDateTime>
#include <QString>
#include <memory>

#include "core/base/result.h"
#include "core/self_test/self_test.h"
#include "ui/report/report_paper.h"

class QPagedPaintDevice;

namespace alidade::ui {

/// The self-test of the core and what the window needs beside it, at one time.
struct InstallationCheck {
  SelfTest test;
  QDateTime at;

  QString product() const;  ///< "Alidade 0.1.0"
};
using SharedInstallationCheck = std::shared_ptr<const InstallationCheck>;

/// Of this program, in the window's thread; a second.
InstallationCheck checkInstallation();

/// The same with the lines of the core at hand, which any thread may work out.
InstallationCheck checkInstallation(SelfTest ofCore);

/// The check on paper: program, machine and libraries, line by line, the verdict. False: painting failed.
bool paintInstallationCheck(QPagedPaintDevice& device, const InstallationCheck& check,
                            const ReportPaper& paper = {});

/// The same as a PDF/A-3b with the check as JSON in it. Answers with the path, or says why not,
/// as where it is one of `inputs`.
Result<QString> writeInstallationCheck(const InstallationCheck& check, const QString& path,
                                       const QStringList& inputs, const ReportPaper& paper = {});

}  // namespace alidade::ui
