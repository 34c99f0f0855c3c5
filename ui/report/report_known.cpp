#include "ui/report/report_parts.h"

#include <algorithm>

#include "core/base/quantity_text.h"
#include "core/effects/catalogue.h"
#include "core/effects/known_sizes.h"
#include "ui/report/report_table.h"
#include "ui/report/report_text.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/known_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

QString sizeText(double value, double sigma, const std::string& unit) {
  const int decimals = decimalsFor(sigma, 2);
  return withUnit(numberText(value, decimals) + QStringLiteral(" ± ") + numberText(sigma, decimals),
                  unitText(unit));
}

QString sourceText(const std::string& from, const std::string& date) {
  QStringList parts;
  for (const std::string& text : {from, date})
    if (!text.empty()) parts.append(visibleLine(text));
  return parts.isEmpty() ? notStated() : Report::list(parts);
}

/// The diagnosis of the number; null if absent.
const KnownCheck* checkOf(const Gap& gap, const Effect& effect, const EffectParameter& number) {
  if (!gap.diagnosis) return nullptr;
  const auto found = std::ranges::find_if(gap.diagnosis->known, [&](const KnownCheck& check) {
    return check.effect == effect.id && check.name == number.name;
  });
  return found == gap.diagnosis->known.end() ? nullptr : &*found;
}

void addTable(ReportSheet& sheet, const Gap& gap, const Measurement& measurement) {
  constexpr auto right = Qt::AlignRight;
  ReportTable table(sheet, {{Report::tr("Number"), 44},
                            {Report::tr("known, 1σ"), 30, right},
                            {Report::tr("these readings, 1σ"), 34, right},
                            {QString(), 4},
                            {Report::tr("known from"), 58}});
  table.head();
  for (const Effect& effect : effectCatalogue())
    for (const EffectParameter& number : effect.parameters) {
      const auto known = knownOf(measurement, number);
      if (!known) continue;
      const double unit = modelUnitsPer(number.unit);
      const KnownCheck* check = checkOf(gap, effect, number);
      table.row({numberName(effect, number),
                 sizeText(known->value / unit, known->sigma / unit, std::string(number.unit)),
                 check && check->isSeen ? sizeText(check->value, check->sigma, check->unit) : notStated(),
                 QString(), sourceText(known->from, known->date)});
    }
  table.finish();
}

}  // namespace

void addKnown(ReportSheet& sheet, const Gap& gap) {
  const auto& measurement = gap.evaluation->examined.measurement;
  if (!measurement || !isAnythingKnown(*measurement)) return;
  sheet.keepTogether(30);
  sheet.heading(Report::tr("Known beforehand of instrument and device"));
  const NamedRecord& record = gap.evaluation->session.instrument.record;
  if (!record.file.empty())
    sheet.paragraph(record.date.empty() ? Report::tr("Instrument record: %1.").arg(visibleLine(record.file))
                                        //: %1: name of a file, %2: a date
                                        : Report::tr("Instrument record: %1 of %2.")
                                              .arg(visibleLine(record.file), visibleLine(record.date)));
  addTable(sheet, gap, *measurement);
  sheet.paragraph(
      Report::tr(
          "Each takes part in the uncertainty and in the search for causes with this value and u; that it "
          "holds no longer was given a chance of one in fifty beforehand. A dash: these readings do not "
          "show it."),
      type::small);
}

}  // namespace alidade::ui
