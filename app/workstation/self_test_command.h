#pragma once

#include <QString>

namespace alidade {

/// `alidade --self-test`: checks this installation, writes the results to `path` as a PDF and the verdict to
/// stdout. Returns the exit code: 0 if it passed; 1 if it failed or could not run; 2 and one line on stderr
/// if the PDF could not be written.
int writeSelfTest(const QString& path);

}  // namespace alidade
