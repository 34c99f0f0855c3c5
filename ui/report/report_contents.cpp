#include "ui/report/report_contents.h"

#include <QCoreApplication>

namespace alidade::ui {

const std::vector<ReportPartInfo>& allReportParts() {
  static const std::vector<ReportPartInfo> parts{
      {ReportPart::Arcs, "arcs", QT_TRANSLATE_NOOP("ReportPart", "Picture of the arcs")},
      {ReportPart::Residuals, "residuals", QT_TRANSLATE_NOOP("ReportPart", "Picture of the residuals")},
      {ReportPart::Readings, "readings", QT_TRANSLATE_NOOP("ReportPart", "Readings")},
      {ReportPart::Journal, "journal", QT_TRANSLATE_NOOP("ReportPart", "Journal of changes")},
      {ReportPart::Method, "method", QT_TRANSLATE_NOOP("ReportPart", "Method")},
      {ReportPart::Budget, "budget", QT_TRANSLATE_NOOP("ReportPart", "Uncertainty budget")},
      {ReportPart::Gap, "gap", QT_TRANSLATE_NOOP("ReportPart", "Gap between model and readings")},
      {ReportPart::Closures, "closures", QT_TRANSLATE_NOOP("ReportPart", "Closures")},
      {ReportPart::Undetectable, "unseen", QT_TRANSLATE_NOOP("ReportPart", "Effects undetectable here")},
      {ReportPart::Signatures, "signatures", QT_TRANSLATE_NOOP("ReportPart", "Signature lines")}};
  return parts;
}

bool isThere(ReportPart part, const Gap& gap) {
  const Evaluation& evaluation = *gap.evaluation;
  switch (part) {
    case ReportPart::Journal:
      return !evaluation.session.journal.empty() || !evaluation.journal.empty();
    case ReportPart::Budget:
      return evaluation.fit.intersection.has_value();
    case ReportPart::Gap:
      return gap.diagnosis && !gap.isNoiseAlone() && (gap.isOpen() || gap.stages.size() >= 2);
    case ReportPart::Closures:
      return gap.diagnosis && !gap.diagnosis->closures.empty();
    case ReportPart::Undetectable:
      return !gap.noticeablyUndetectable().empty();
    default:
      return true;
  }
}

bool isMandatory(ReportPart part, const Gap& gap) {
  return part == ReportPart::Gap && gap.isOpen() && isThere(part, gap);
}

bool isPrinted(ReportPart part, const ReportContents& contents, const Gap& gap) {
  return isThere(part, gap) && (!contents.leftOut.contains(part) || isMandatory(part, gap));
}

QStringList leftOutTitles(const ReportContents& contents, const Gap& gap) {
  QStringList titles;
  for (const ReportPartInfo& info : allReportParts())
    if (isThere(info.part, gap) && !isPrinted(info.part, contents, gap))
      titles.append(QCoreApplication::translate("ReportPart", info.title));
  return titles;
}

}  // namespace alidade::ui
