#pragma once

#include <QString>

namespace alidade {

/// `alidade --self-test`: checks this installation, writes the lines to `path` as a PDF and the verdict to
/// stdout. Answers with the exit code: 0 it passed; 1 it did not, or failed to be checked; 2 and one line on
/// stderr where the PDF could not be written.
int writeSelfTest(const QString& path);

}  // namespace alidade
