#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ui/report/report_paper.h"

class QPagedPaintDevice;

namespace alidade::ui {

/// The PDF/A-1b that Qt writes of what `paint` draws, for `archivedPdf`. Absent if `paint` reports failure.
std::optional<std::string> paintedPdf(const ReportPaper& paper,
                                      const std::function<bool(QPagedPaintDevice& device)>& paint);

}  // namespace alidade::ui
