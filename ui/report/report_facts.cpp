#include "ui/report/report_facts.h"

#include <algorithm>
#include <vector>

#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

struct Fact {
  QString label, value;
};

QString stated(const std::string& text, const QString& unit = {}) {
  constexpr int longest = 120;
  const QString value = shortLine(QString::fromStdString(text).trimmed(), longest);
  return value.isEmpty() ? notStated() : value + unit;
}

/// A dash and what the fit takes instead where nothing is stated.
QString withUsual(const std::string& text, const QString& unit, const QString& usual) {
  return QString::fromStdString(text).trimmed().isEmpty()
             ? notStated() + QStringLiteral(" (taken as ") + usual + u')'
             : stated(text, unit);
}

QString nameAndSerial(const std::string& name, const std::string& serial) {
  return stated(name) + QStringLiteral(", serial ") + stated(serial);
}

std::vector<Fact> objectFacts(const Session& session, const QDateTime& date) {
  return {{QStringLiteral("Device"), nameAndSerial(session.device.name, session.device.serial)},
          {QStringLiteral("Operator"), stated(session.operatorName)},
          {QStringLiteral("Place"), stated(session.place)},
          {QStringLiteral("Measured on"), stated(session.measuredOn)},
          {QStringLiteral("Report made"), date.toString(QStringLiteral("yyyy-MM-dd HH:mm"))},
          {QStringLiteral("Temperature"), stated(session.environment.temperatureC, QStringLiteral(" °C"))}};
}

std::vector<Fact> instrumentFacts(const Session& session) {
  const Instrument& instrument = session.instrument;
  const Geometry& geometry = session.geometry;
  const QString arcsec(QChar(0x2033)), mm = QStringLiteral(" mm"), usual = QStringLiteral("2″");
  const QString planar =
      session.model.verticalAngle == "planar" ? QStringLiteral(", planar relation") : QString();
  return {{QStringLiteral("Instrument"), nameAndSerial(instrument.name, instrument.serial)},
          {QStringLiteral("σ of the circles"),
           QStringLiteral("horizontal %1, vertical %2")
               .arg(withUsual(instrument.sigmaHorizontalArcsec, arcsec, usual),
                    withUsual(instrument.sigmaVerticalArcsec, arcsec, usual))},
          {QStringLiteral("σ pointing zero"),
           withUsual(instrument.sigmaZeroArcsec, arcsec, QStringLiteral("that of the circles"))},
          {QStringLiteral("Distance L"),
           QStringLiteral("%1, σ %2")
               .arg(stated(geometry.distanceMm, mm),
                    withUsual(geometry.sigmaDistanceMm, mm, QStringLiteral("exact")))},
          {QStringLiteral("Nominal radius R0"),
           geometry.sigmaRadiusMm.empty()
               ? stated(geometry.radiusMm, mm)
               : QStringLiteral("%1, σ %2")
                     .arg(stated(geometry.radiusMm, mm), stated(geometry.sigmaRadiusMm, mm))},
          {QStringLiteral("Vertical circle"),
           withUsual(geometry.verticalCircle, {}, QStringLiteral("zenith")) + planar}};
}

double addColumn(ReportSheet& sheet, const std::vector<Fact>& facts, double left, double top,
                 double available) {
  constexpr double labelWidth = 33;
  for (const Fact& fact : facts) {
    sheet.text(fact.label, type::label, left, top, labelWidth);
    for (const QString& line : sheet.lines(fact.value, type::body, available - labelWidth)) {
      sheet.text(line, type::body, left + labelWidth, top, available - labelWidth);
      top += sheet.lineHeight(type::body);
    }
  }
  return top;
}

}  // namespace

void addFacts(ReportSheet& sheet, const Evaluation& evaluation, const QDateTime& date) {
  constexpr double column = 83;
  const Session& session = evaluation.session;
  const std::vector<Fact> right = instrumentFacts(session);
  sheet.skip(2.5);
  const double top = sheet.y();
  const double leftEnd = addColumn(sheet, objectFacts(session, date), 0, top, column);
  const double rightEnd = addColumn(sheet, right, ReportSheet::width - column, top, column);
  sheet.skip(std::max(leftEnd, rightEnd) - top);
}

}  // namespace alidade::ui
