#pragma once

#include <QStringList>

#include "core/session/session.h"

namespace alidade::ui {

/// Fields that a laboratory states on a report but the session leaves empty, as nouns ("customer"), in the
/// order of the session file.
QStringList emptyReportFields(const Session& session);

}  // namespace alidade::ui
