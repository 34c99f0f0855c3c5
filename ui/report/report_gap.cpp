#include <algorithm>

#include "core/statement/gap.h"
#include "ui/report/report_parts.h"
#include "ui/report/report_sheet.h"
#include "ui/report/report_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

void addGap(ReportSheet& sheet, const Gap& gap) {
  if (!gap.diagnosis || gap.isNoiseAlone() || (!gap.isOpen() && gap.stages.size() < 2)) return;
  constexpr double headAndTable = 70;  // mm, about
  sheet.keepTogether(std::min(headAndTable, sheet.height() / 2));
  sheet.heading(Report::tr("Gap between model and readings"));
  const Statement verdict = gapVerdict(gap);
  //: a headline as a sentence
  sheet.paragraph(Report::tr("%1.").arg(qText(verdict.title)), type::body.inBold());
  QStringList sentences;
  for (const std::string& sentence : verdict.sentences) sentences.append(qText(sentence));
  sheet.paragraph(Report::sentences(sentences));
  addStatement(sheet, gapCauses(gap));
  addStatement(sheet, gapStages(gap));
  if (gap.isOpen())
    sheet.paragraph(Report::tr("Unless marked “measured”, the figures of this report are those of the "
                               "session's model; the diagnosis neither added nor removed anything. The "
                               "verdict holds only if both results, measured and fit only, agree."),
                    type::small);
}

void addClosures(ReportSheet& sheet, const Gap& gap) {
  if (!gap.diagnosis || gap.diagnosis->closures.empty()) return;
  addStatement(sheet, gapClosures(gap));
  addStatement(sheet, gapRequired(gap));
}

void addUndetectable(ReportSheet& sheet, const Gap& gap) {
  if (!gap.diagnosis || gap.noticeablyUndetectable().empty()) return;
  addStatement(sheet, gapUndetectable(gap));
  addStatement(sheet, gapAdvice(gap));
}

void addKnown(ReportSheet& sheet, const Gap& gap) {
  const Statement known = gapKnown(gap);
  if (known.rows.empty()) return;
  addStatement(sheet, known);
  const NamedRecord& record = gap.evaluation->session.instrument.record;
  if (record.file.empty()) return;
  sheet.paragraph(record.date.empty() ? Report::tr("Instrument record: %1.").arg(visibleLine(record.file))
                                      //: %1: name of a file, %2: a date
                                      : Report::tr("Instrument record: %1 of %2.")
                                            .arg(visibleLine(record.file), visibleLine(record.date)),
                  type::small);
}

}  // namespace alidade::ui
