#include "ui/report/report_facts.h"

#include <algorithm>
#include <vector>

#include "core/observation/visits.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

constexpr double labelWidth = 31;  // mm

/// As the session has it, short; empty where it is not given.
QString given(const std::string& text, const QString& unit = {}) {
  constexpr int longest = 120;
  const QString value = shortLine(QString::fromStdString(text).trimmed(), longest);
  return value.isEmpty() ? value : value + unit;
}

/// Of a σ: as stated in the session, or what is taken where it states none.
struct Provenance {
  QString value, from;

  Provenance(const std::string& text, const QString& unit, const QString& usual)
      : value(given(text, unit)), from(QStringLiteral("stated")) {
    if (!value.isEmpty()) return;
    value = usual;
    from = QStringLiteral("default");
  }
  QString text() const { return QStringLiteral("%1 (%2)").arg(value, from); }
};

QString nameAndSerial(const std::string& name, const std::string& serial) {
  QStringList parts;
  if (const QString text = given(name); !text.isEmpty()) parts.append(text);
  if (const QString text = given(serial); !text.isEmpty()) parts.append(QStringLiteral("serial ") + text);
  return parts.join(QStringLiteral(", "));
}

QString sigmaOfCircles(const Instrument& instrument) {
  const QString arcsec(QChar(0x2033)), usual = QStringLiteral("2″");
  const Provenance horizontal(instrument.sigmaHorizontalArcsec, arcsec, usual),
      vertical(instrument.sigmaVerticalArcsec, arcsec, usual);
  const bool isAlike = horizontal.from == vertical.from;
  return QStringLiteral("horizontal %1, vertical %2")
      .arg(isAlike ? horizontal.value : horizontal.text(), vertical.text());
}

bool readsSlider(const Evaluation& evaluation) {
  const auto& measurement = evaluation.examined.measurement;
  return measurement && std::ranges::any_of(measurement->arcs, hasSliderReadings);
}

QString lengthWithSigma(const std::string& length, const std::string& sigma) {
  const QString mm = QStringLiteral(" mm"), value = given(length, mm), stated = given(sigma);
  const Provenance from(stated.isEmpty() ? std::string() : "σ " + stated.toStdString(), mm,
                        QStringLiteral("taken as exact"));
  return value.isEmpty() ? value : QStringLiteral("%1, %2").arg(value, from.text());
}

/// Its σ is of use where the radius is known, or as a closure where it is stated.
QString nominalRadius(const Session& session) {
  const Geometry& geometry = session.geometry;
  if (given(geometry.sigmaRadiusMm).isEmpty() && session.model.radius != "known")
    return given(geometry.radiusMm, QStringLiteral(" mm"));
  return lengthWithSigma(geometry.radiusMm, geometry.sigmaRadiusMm);
}

std::vector<LabelledText> objectFacts(const Session& session, const QDateTime& date) {
  return {{QStringLiteral("Laboratory"), given(session.report.laboratory)},
          {QStringLiteral("Customer"), given(session.report.customer)},
          {QStringLiteral("Device"), nameAndSerial(session.device.name, session.device.serial)},
          {QStringLiteral("Operator"), given(session.operatorName)},
          {QStringLiteral("Place"), given(session.place)},
          {QStringLiteral("Measured on"), given(session.measuredOn)},
          {QStringLiteral("Report made"), date.toString(QStringLiteral("yyyy-MM-dd HH:mm"))}};
}

std::vector<LabelledText> instrumentFacts(const Evaluation& evaluation) {
  const Session& session = evaluation.session;
  const Instrument& instrument = session.instrument;
  const Geometry& geometry = session.geometry;
  const QString arcsec(QChar(0x2033));
  const QString planar =
      session.model.verticalAngle == "planar" ? QStringLiteral(", planar relation") : QString();
  std::vector<LabelledText> facts{
      {QStringLiteral("Instrument"), nameAndSerial(instrument.name, instrument.serial)},
      {QStringLiteral("Certificate"), given(instrument.certificate)},
      {QStringLiteral("Circles traceable"), given(instrument.traceability)},
      {QStringLiteral("σ of the circles"), sigmaOfCircles(instrument)},
      {QStringLiteral("σ pointing zero"),
       Provenance(instrument.sigmaZeroArcsec, arcsec, QStringLiteral("that of the circles")).text()}};
  if (readsSlider(evaluation))
    facts.push_back({QStringLiteral("σ of the slider"),
                     Provenance(instrument.sigmaSliderArcsec, arcsec, QStringLiteral("5″")).text()});
  facts.push_back(
      {QStringLiteral("Distance L"), lengthWithSigma(geometry.distanceMm, geometry.sigmaDistanceMm)});
  facts.push_back({QStringLiteral("L measured"), given(geometry.distanceFrom)});
  facts.push_back({QStringLiteral("Nominal radius R0"), nominalRadius(session)});
  facts.push_back({QStringLiteral("Vertical circle"),
                   Provenance(geometry.verticalCircle, {}, QStringLiteral("zenith")).value + planar});
  return facts;
}

}  // namespace

double placeLabelled(ReportSheet& sheet, const std::vector<LabelledText>& texts, double left, double top,
                     double available) {
  const TextStyle& style = type::detail;
  const TextStyle label = style.inColour(type::label.colour);
  for (const LabelledText& labelled : texts) {
    if (labelled.text.isEmpty()) continue;
    sheet.text(labelled.label, label, left, top, labelWidth);
    for (const QString& line : sheet.lines(labelled.text, style, available - labelWidth)) {
      sheet.text(line, style, left + labelWidth, top, available - labelWidth);
      top += sheet.lineHeight(style);
    }
  }
  return top;
}

double labelledHeight(const ReportSheet& sheet, const std::vector<LabelledText>& texts, double available) {
  qsizetype lines = 0;
  for (const LabelledText& labelled : texts)
    if (!labelled.text.isEmpty())
      lines += sheet.lines(labelled.text, type::detail, available - labelWidth).size();
  return static_cast<double>(lines) * sheet.lineHeight(type::detail);
}

void addFacts(ReportSheet& sheet, const Evaluation& evaluation, const QDateTime& date) {
  constexpr double column = 83;
  const Session& session = evaluation.session;
  sheet.skip(2.5);
  const double top = sheet.y();
  const double leftEnd = placeLabelled(sheet, objectFacts(session, date), 0, top, column);
  const double rightEnd =
      placeLabelled(sheet, instrumentFacts(evaluation), ReportSheet::width - column, top, column);
  sheet.skip(std::max(leftEnd, rightEnd) - top);
}

}  // namespace alidade::ui
