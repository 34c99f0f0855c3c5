#include "ui/report/report_facts.h"

#include <algorithm>
#include <vector>

#include "core/observation/visits.h"
#include "core/session/row_fields.h"
#include "ui/report/report_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

constexpr double labelWidth = 31;  // mm

/// `text` of the session, shortened, with its unit; empty if `text` is empty.
QString given(const std::string& text, const QString& unit = {}) {
  constexpr int longest = 120;
  const QString value = shortLine(QString::fromStdString(text).trimmed(), longest);
  return value.isEmpty() ? value : value + unit;
}

/// A value, and whether the session states the value; if not, the value is the default.
struct Provenance {
  QString value;
  bool isStated;

  Provenance(const std::string& text, const QString& unit, const QString& usual)
      : value(given(text, unit)), isStated(!value.isEmpty()) {
    if (!isStated) value = usual;
  }
  QString text() const {
    //: a standard uncertainty, as stated in the session or as the program assumes it
    return (isStated ? Report::tr("%1 (stated)") : Report::tr("%1 (default)")).arg(value);
  }
};

QString nameAndSerial(const std::string& name, const std::string& serial) {
  QStringList parts;
  if (const QString text = given(name); !text.isEmpty()) parts.append(text);
  if (const QString text = given(serial); !text.isEmpty())
    parts.append(Report::tr("serial number %1").arg(text));
  return listText(parts);
}

QString sigmaOfCircles(const Instrument& instrument) {
  const QString arcsec(QChar(0x2033)), usual = QStringLiteral("2″");
  const Provenance horizontal(instrument.sigmaHorizontalArcsec, arcsec, usual),
      vertical(instrument.sigmaVerticalArcsec, arcsec, usual);
  const bool isAlike = horizontal.isStated == vertical.isStated;
  return Report::tr("horizontal %1, vertical %2")
      .arg(isAlike ? horizontal.value : horizontal.text(), vertical.text());
}

bool readsSlider(const Evaluation& evaluation) {
  const auto& measurement = evaluation.examined.measurement;
  return measurement && std::ranges::any_of(measurement->arcs, hasSliderReadings);
}

QString lengthWithSigma(const std::string& length, const std::string& sigma) {
  const QString value = given(length, QStringLiteral(" mm")), stated = given(sigma);
  if (value.isEmpty()) return value;
  return stated.isEmpty() ? Report::tr("%1, taken as exact (default)").arg(value)
                          : Report::tr("%1, σ %2 mm (stated)").arg(value, stated);
}

/// R0, with its σ if the radius is known, or if σ is stated for the closure.
QString nominalRadius(const Session& session) {
  const Geometry& geometry = session.geometry;
  if (given(geometry.sigmaRadiusMm).isEmpty() && session.model.radius != "known")
    return given(geometry.radiusMm, QStringLiteral(" mm"));
  return lengthWithSigma(geometry.radiusMm, geometry.sigmaRadiusMm);
}

/// The angle that the vertical circle reads: zenith (also if empty) or elevation; an unknown word as typed.
QString verticalCircle(const Session& session) {
  const QString typed = given(session.geometry.verticalCircle);
  const bool isZenith = typed.isEmpty() || typed == QStringLiteral("zenith");
  //: what the vertical circle reads: zenith angles
  QString reads = isZenith ? Report::tr("zenith") : typed;
  //: what the vertical circle reads: elevation angles
  if (typed == QStringLiteral("elevation")) reads = Report::tr("elevation");
  return session.model.verticalAngle == "planar" ? Report::tr("%1, planar relation").arg(reads) : reads;
}

std::vector<LabelledText> objectFacts(const Session& session, const QDateTime& date) {
  return {{Report::tr("Laboratory"), given(session.report.laboratory)},
          {Report::tr("Customer"), given(session.report.customer)},
          {Report::tr("Device"), nameAndSerial(session.device.name, session.device.serial)},
          {Report::tr("Condition"), given(session.device.condition)},
          {Report::tr("Received on"), given(session.device.receivedOn)},
          {Report::tr("Operator"), given(session.operatorName)},
          {Report::tr("Place"), given(session.place)},
          {Report::tr("Measured on"), given(session.measuredOn)},
          {Report::tr("Report made"), date.toString(QStringLiteral("yyyy-MM-dd HH:mm"))}};
}

std::vector<LabelledText> instrumentFacts(const Evaluation& evaluation) {
  const Session& session = evaluation.session;
  const Instrument& instrument = session.instrument;
  const Geometry& geometry = session.geometry;
  const QString arcsec(QChar(0x2033));
  std::vector<LabelledText> facts{
      {Report::tr("Instrument"), nameAndSerial(instrument.name, instrument.serial)},
      {Report::tr("Certificate"), given(instrument.certificate)},
      {Report::tr("Circles traceable"), given(instrument.traceability)},
      {Report::tr("σ of the circles"), sigmaOfCircles(instrument)},
      {Report::tr("σ pointing zero"), Provenance(instrument.sigmaZeroArcsec, arcsec,
                                                 //: a standard uncertainty: as that of the circles
                                                 Report::tr("that of the circles"))
                                          .text()}};
  if (readsSlider(evaluation))
    facts.push_back({Report::tr("σ of the slider"),
                     Provenance(instrument.sigmaSliderArcsec, arcsec, QStringLiteral("5″")).text()});
  if (hasCompensatorTexts(session))
    facts.push_back({Report::tr("σ compensator"),
                     Provenance(instrument.sigmaCompensatorArcsec, arcsec, QStringLiteral("1″")).text()});
  if (const LineOfSight& sight = instrument.lineOfSight; !sight.offsetMm.empty())
    facts.push_back({Report::tr("Line of sight offset"), lengthWithSigma(sight.offsetMm, sight.sigmaMm)});
  facts.push_back({Report::tr("Distance L"), lengthWithSigma(geometry.distanceMm, geometry.sigmaDistanceMm)});
  facts.push_back({Report::tr("L measured"), given(geometry.distanceFrom)});
  facts.push_back({Report::tr("Nominal radius R0"), nominalRadius(session)});
  facts.push_back({Report::tr("Vertical circle"), verticalCircle(session)});
  return facts;
}

struct LabelledLines {
  QStringList label, text;

  qsizetype count() const { return std::max(label.size(), text.size()); }
};

const TextStyle labelStyle = type::detail.inColour(type::label.colour);

LabelledLines linesOf(const ReportSheet& sheet, const LabelledText& labelled, double available) {
  constexpr double between = 1;  // mm
  return {sheet.lines(labelled.label, labelStyle, labelWidth - between),
          sheet.lines(labelled.text, type::detail, available - labelWidth)};
}

}  // namespace

double placeLabelled(ReportSheet& sheet, const std::vector<LabelledText>& texts, double left, double top,
                     double available) {
  const double line = sheet.lineHeight(type::detail);
  for (const LabelledText& labelled : texts) {
    if (labelled.text.isEmpty()) continue;
    const LabelledLines lines = linesOf(sheet, labelled, available);
    const auto place = [&](const QStringList& broken, const TextStyle& style, double at, double width) {
      for (qsizetype i = 0; i < broken.size(); ++i)
        sheet.text(broken[i], style, at, top + static_cast<double>(i) * line, width);
    };
    place(lines.label, labelStyle, left, labelWidth);
    place(lines.text, type::detail, left + labelWidth, available - labelWidth);
    top += static_cast<double>(lines.count()) * line;
  }
  return top;
}

double labelledHeight(const ReportSheet& sheet, const std::vector<LabelledText>& texts, double available) {
  qsizetype lines = 0;
  for (const LabelledText& labelled : texts)
    if (!labelled.text.isEmpty()) lines += linesOf(sheet, labelled, available).count();
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
