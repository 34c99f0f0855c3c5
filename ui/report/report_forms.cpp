#include "ui/report/report_parts.h"

#include <memory>

#include "core/statement/gap.h"
#include "core/wording/form_sentence.h"
#include "ui/charts/gap/form_plot.h"
#include "ui/report/report_text.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

constexpr double plotHeight = 62;  // mm

QString formCaption(const FormPlot& plot) {
  QStringList sentences{
      Report::tr("The curve is the form. Hollow marks are the value that each sighting gives for the form, "
                 "with everything else in the model."),
      plot.isHeldOut()
          ? Report::tr("Filled marks: these values minus the form, fitted without the sighting itself.")
          : Report::tr("Filled marks: these values minus the form."),
      Report::tr("Broken lines: ±1σ of the most sensitive sighting, from the stated noise.")};
  if (!plot.form().cleanRange.empty()) sentences.append(Report::tr("Grey: where the model holds."));
  return Report::sentences(sentences);
}

}  // namespace

void addForms(ReportSheet& sheet, const Gap& gap) {
  if (!gap.diagnosis || gap.diagnosis->forms.empty()) return;
  const Statement statement = gapForms(gap);
  const std::vector<FoundForm>& forms = gap.diagnosis->forms;
  constexpr double aroundPlot = 50;  // heading, sentences and caption
  sheet.keepTogether(plotHeight + aroundPlot);
  sheet.heading(qText(statement.title));
  for (std::size_t i = 0; i < forms.size(); ++i) {
    if (i > 0) sheet.keepTogether(plotHeight + aroundPlot);
    sheet.paragraph(qText(formSentence(forms[i])));
    if (const std::string clean = cleanRangeSentence(forms[i]); !clean.empty()) sheet.paragraph(qText(clean));
    const auto plot = std::make_shared<FormPlot>();
    plot->setForm(gap, i);
    addPlot(sheet, plot, plotHeight);
    sheet.paragraph(formCaption(*plot), type::small);
  }
  if (const std::string shrink = shrinkSentence(forms.front()); !shrink.empty())
    sheet.paragraph(qText(shrink));
  sheet.paragraph(qText(statement.note), type::small);
}

}  // namespace alidade::ui
