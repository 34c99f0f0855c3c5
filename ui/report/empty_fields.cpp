#include "ui/report/empty_fields.h"

#include <QCoreApplication>

#include "core/session/session_fields.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

bool isWanted(const SessionField& field, const Session& session) {
  if (field.key == "report.rule_agreed_by" && session.acceptance.toleranceMm.empty()) return false;
  return field.isWantedOnReport;
}

}  // namespace

QStringList emptyReportFields(const Session& session) {
  QStringList nouns;
  for (const SessionField& field : sessionFields())
    if (isWanted(field, session) && qText(field.get(session)).trimmed().isEmpty())
      nouns.append(QCoreApplication::translate("Field", field.noun));
  return nouns;
}

}  // namespace alidade::ui
