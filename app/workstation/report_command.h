#pragma once

#include <QString>

namespace alidade {

/// `alidade --report`: writes the acceptance report of the session in `path`. Answers with the exit code: 0;
/// 2 and one line on stderr where the session or the place of the report is no good; 1 and one line where it
/// fails.
int writeReport(const QString& path, const QString& reportPath);

}  // namespace alidade
