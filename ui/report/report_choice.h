#pragma once

#include <QString>

#include "ui/report/report_contents.h"
#include "ui/report/report_paper.h"

namespace alidade::ui {

/// What is chosen for a report before it is written or printed.
struct ReportChoice {
  ReportContents contents = {};
  ReportPaper paper = {};
  QString logoPath = {};      ///< of an image; empty: none
  QString language = {};      ///< id of a `LanguageInfo`; empty: that of the window
  QString seriesFolder = {};  ///< of sessions of the device, whose history is told; empty: it is not
  bool hasSession = true;     ///< session and results are attached to the PDF

  bool operator==(const ReportChoice&) const = default;
};

}  // namespace alidade::ui
