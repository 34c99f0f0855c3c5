#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ui/report/report_paper.h"

class QPagedPaintDevice;

namespace alidade::ui {

/// A document as Qt writes it, PDF/A-1b, for `archivedPdf`. Absent if `paint` reports failure.
std::optional<std::string> paintedPdf(const ReportPaper& paper,
                                      const std::function<bool(QPagedPaintDevice& device)>& paint);

}  // namespace alidade::ui
