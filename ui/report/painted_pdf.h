#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ui/report/report_paper.h"

class QPagedPaintDevice;

namespace alidade::ui {

/// What `paint` draws, as a PDF/A-1b written by Qt for `archivedPdf`. Absent if `paint` returns false.
std::optional<std::string> paintedPdf(const ReportPaper& paper,
                                      const std::function<bool(QPagedPaintDevice& device)>& paint);

}  // namespace alidade::ui
