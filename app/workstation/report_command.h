#pragma once

#include <QString>

namespace alidade {

/// `alidade --report`: writes the acceptance report of the session in `path`. Answers with the exit code: 0,
/// or 2 and one line on stderr where the session or the place of the report is no good.
int writeReport(const QString& path, const QString& reportPath);

}  // namespace alidade
