#include "ui/report/empty_fields.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>

#include "ui/document/field.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

// ISO/IEC 17025:2017, 7.8.2, 7.8.4 and, for the decision rule, 7.8.6.
constexpr std::string_view wanted[] = {"operator",
                                       "place",
                                       "measured_on",
                                       "report.number",
                                       "report.laboratory",
                                       "report.customer",
                                       "report.authorised_by",
                                       "report.rule_agreed_by",
                                       "device.name",
                                       "device.serial",
                                       "instrument.name",
                                       "instrument.serial",
                                       "instrument.certificate",
                                       "instrument.traceability",
                                       "environment.temperature_c",
                                       "geometry.sigma_distance_mm",
                                       "geometry.distance_from"};

bool isWanted(const Field& field, const Session& session) {
  if (field.name == "report.rule_agreed_by" && session.acceptance.toleranceMm.empty()) return false;
  return std::ranges::find(wanted, field.name) != std::end(wanted);
}

}  // namespace

QStringList emptyReportFields(const Session& session) {
  QStringList nouns;
  for (const Field& field : allFields())
    if (isWanted(field, session) && qText(field.get(session, 0)).trimmed().isEmpty())
      nouns.append(QCoreApplication::translate("Field", field.noun));
  return nouns;
}

}  // namespace alidade::ui
