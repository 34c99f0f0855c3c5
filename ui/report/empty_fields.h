#pragma once

#include <QStringList>

#include "core/session/session.h"

namespace alidade::ui {

/// What a laboratory states on a report and the session leaves empty, as nouns ("customer"), in the order of
/// the session file.
QStringList emptyReportFields(const Session& session);

}  // namespace alidade::ui
