#pragma once

#include <QString>
#include <QStringList>
#include <set>
#include <vector>

#include "ui/jobs/gap.h"

namespace alidade::ui {

/// A part of a report that may be left out. The others may not: the result with its uncertainty and verdict,
/// what speaks against it, the terms it is stated on, what was excluded or changed, the notes.
enum class ReportPart {
  Arcs,
  Residuals,
  Readings,
  Journal,
  Method,
  Budget,
  Gap,
  Closures,
  Unseen,
  Signatures
};

struct ReportPartInfo {
  ReportPart part;
  const char* id;     ///< in the settings
  const char* title;  ///< as printed and in the window, in the context `ReportPart`
};

/// In the order of the report.
const std::vector<ReportPartInfo>& allReportParts();

/// What a report holds: everything, but for what is left out.
struct ReportContents {
  std::set<ReportPart> leftOut = {};

  bool operator==(const ReportContents&) const = default;
};

/// Is there anything to print in this part?
bool isThere(ReportPart part, const Gap& gap);

/// Must it stand in the report whatever is chosen? The gap must where model and readings disagree.
bool mustStand(ReportPart part, const Gap& gap);

/// Is it printed?
bool isPrinted(ReportPart part, const ReportContents& contents, const Gap& gap);

/// The titles of what would be there and is left out, as printed.
QStringList leftOutTitles(const ReportContents& contents, const Gap& gap);

}  // namespace alidade::ui
