#pragma once

#include "ui/report/acceptance_report.h"

namespace alidade::ui {

class SessionDocument;

/// The file named in a report of the document. Its bytes and their hash are read unless the session has
/// unsaved changes; `saved` is true if the file equals the session.
ReportSource reportSource(const SessionDocument& document);

}  // namespace alidade::ui
