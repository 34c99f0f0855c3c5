#pragma once

#include <QString>

#include "ui/report/report_contents.h"
#include "ui/report/report_paper.h"

namespace alidade::ui {

/// What is chosen for a report before it is written or printed.
struct ReportChoice {
  ReportContents contents = {};
  ReportPaper paper = {};
  QString logoPath = {};   ///< of an image; empty: none
  bool hasSession = true;  ///< the session is attached to the PDF

  bool operator==(const ReportChoice&) const = default;
};

}  // namespace alidade::ui
