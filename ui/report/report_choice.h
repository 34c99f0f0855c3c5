#pragma once

#include <QString>

#include "ui/report/report_contents.h"
#include "ui/report/report_paper.h"

namespace alidade::ui {

/// A language that a report can be written in, under the name that its readers know.
struct ReportLanguage {
  const char *code, *name;
};
inline constexpr ReportLanguage reportLanguages[] = {{"en", "English"}, {"zh_CN", "简体中文"}};

/// What is chosen for a report before it is written or printed.
struct ReportChoice {
  ReportContents contents = {};
  ReportPaper paper = {};
  QString logoPath = {};   ///< of an image; empty: none
  QString language = {};   ///< one of `reportLanguages`; empty: that of the window
  bool hasSession = true;  ///< session and results are attached to the PDF

  bool operator==(const ReportChoice&) const = default;
};

}  // namespace alidade::ui
