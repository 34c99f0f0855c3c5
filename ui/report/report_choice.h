#pragma once

#include <QString>

#include "ui/report/certificate.h"
#include "ui/report/report_contents.h"
#include "ui/report/report_paper.h"

namespace alidade::ui {

/// The user's choice for a report before it is written or printed.
struct ReportChoice {
  ReportContents contents = {};
  ReportPaper paper = {};
  QString logoPath = {};  ///< path of an image; empty: none
  QString language = {};  ///< id of a `LanguageInfo`; empty: the window's language
  QString seriesFolder =
      {};  ///< folder with sessions of the device, whose history is included; empty: no history
  bool hasSession = true;  ///< session and results are attached to the PDF

  CertificateEntries certificate = {};  ///< used only for a certificate

  bool operator==(const ReportChoice&) const = default;
};

/// The last choice on this machine; invalid stored values are ignored.
ReportChoice rememberedReportChoice();
void rememberReportChoice(const ReportChoice& choice);

}  // namespace alidade::ui
