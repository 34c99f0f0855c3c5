#pragma once

#include "ui/report/acceptance_report.h"

namespace alidade::ui {

class SessionDocument;

/// The file a report of the document speaks of, with the hash of its bytes: the saved file where it is
/// unchanged, otherwise the session as it would be saved.
ReportSource reportSource(const SessionDocument& document);

}  // namespace alidade::ui
