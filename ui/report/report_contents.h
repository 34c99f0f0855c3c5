#pragma once

#include <QString>
#include <QStringList>
#include <set>
#include <vector>

#include "core/evaluation/gap.h"

namespace alidade::ui {

/// A part of a report that may be left out. Always included: the result with its uncertainty and verdict,
/// objections, terms, excluded or changed entries, and notes.
enum class ReportPart {
  Arcs,
  Residuals,
  Readings,
  Journal,
  Method,
  Budget,
  Gap,
  Closures,
  Undetectable,
  Signatures
};

struct ReportPartInfo {
  ReportPart part;
  const char* id;     ///< key in the settings
  const char* title;  ///< title in print and in the window, in the context `ReportPart`
};

/// All parts that may be left out, in the order of the report.
const std::vector<ReportPartInfo>& allReportParts();

/// The contents of a report: everything except the parts left out.
struct ReportContents {
  std::set<ReportPart> leftOut = {};

  bool operator==(const ReportContents&) const = default;
};

/// True if the part has contents.
bool isThere(ReportPart part, const Gap& gap);

/// True if the report must include the part: the gap is mandatory if model and readings disagree.
bool isMandatory(ReportPart part, const Gap& gap);

/// True if the part is printed.
bool isPrinted(ReportPart part, const ReportContents& contents, const Gap& gap);

/// The printed titles of available parts that are left out.
QStringList leftOutTitles(const ReportContents& contents, const Gap& gap);

}  // namespace alidade::ui
