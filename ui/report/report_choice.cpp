#include "ui/report/report_choice.h"

#include <QSettings>
#include <algorithm>

#include "ui/language/languages.h"

namespace alidade::ui {

namespace {

const QString group = QStringLiteral("report/");

double marginOf(const QSettings& settings, const char* side, double usual) {
  bool isNumber = false;
  const double stored = settings.value(group + QString::fromLatin1(side), usual).toDouble(&isNumber);
  return isNumber ? std::clamp(stored, ReportPaper::leastMargin, ReportPaper::mostMargin) : usual;
}

ReportPaper storedPaper(const QSettings& settings) {
  const QMarginsF usual = ReportPaper().margins;
  ReportPaper paper;
  if (settings.value(group + QStringLiteral("paper")).toString() == QStringLiteral("Letter"))
    paper.size = QPageSize::Letter;
  paper.margins = {
      marginOf(settings, "marginLeft", usual.left()), marginOf(settings, "marginTop", usual.top()),
      marginOf(settings, "marginRight", usual.right()), marginOf(settings, "marginBottom", usual.bottom())};
  return paper;
}

QString storedLanguage(const QSettings& settings) {
  const QString stored = settings.value(group + QStringLiteral("language")).toString();
  const bool isOurs = std::ranges::find(allLanguages(), stored, &LanguageInfo::id) != allLanguages().end();
  return isOurs ? stored : QString();
}

}  // namespace

ReportChoice rememberedReportChoice() {
  const QSettings settings;
  ReportChoice choice{.paper = storedPaper(settings),
                      .logoPath = settings.value(group + QStringLiteral("logo")).toString(),
                      .language = storedLanguage(settings),
                      .seriesFolder = settings.value(group + QStringLiteral("series")).toString(),
                      .hasSession = settings.value(group + QStringLiteral("session"), true).toBool()};
  const auto text = [&](const char* name) {
    return settings.value(group + QString::fromLatin1(name)).toString();
  };
  choice.certificate = {.measuredOn = {},
                        .country = text("country"),
                        .performedAt = text("performedAt"),
                        .manufacturer = text("manufacturer")};
  const QStringList leftOut = settings.value(group + QStringLiteral("leftOut")).toStringList();
  for (const ReportPartInfo& info : allReportParts())
    if (leftOut.contains(QString::fromLatin1(info.id))) choice.contents.leftOut.insert(info.part);
  return choice;
}

void rememberReportChoice(const ReportChoice& choice) {
  QSettings settings;
  const auto put = [&](const char* name, const QVariant& value) {
    settings.setValue(group + QString::fromLatin1(name), value);
  };
  QStringList leftOut;
  for (const ReportPartInfo& info : allReportParts())
    if (choice.contents.leftOut.contains(info.part)) leftOut.append(QString::fromLatin1(info.id));
  put("leftOut", leftOut);
  put("paper", choice.paper.size == QPageSize::Letter ? QStringLiteral("Letter") : QStringLiteral("A4"));
  put("marginLeft", choice.paper.margins.left());
  put("marginTop", choice.paper.margins.top());
  put("marginRight", choice.paper.margins.right());
  put("marginBottom", choice.paper.margins.bottom());
  put("logo", choice.logoPath);
  put("language", choice.language);
  put("series", choice.seriesFolder);
  put("session", choice.hasSession);
  put("country", choice.certificate.country);
  put("performedAt", choice.certificate.performedAt);
  put("manufacturer", choice.certificate.manufacturer);
}

}  // namespace alidade::ui
