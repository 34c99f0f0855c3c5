#pragma once

#include "ui/report/acceptance_report.h"

namespace alidade::ui {

class SessionDocument;

/// The file named in a report of the document, with the hash of its bytes: the saved file if unchanged,
/// otherwise the session as it would be saved.
ReportSource reportSource(const SessionDocument& document);

}  // namespace alidade::ui
