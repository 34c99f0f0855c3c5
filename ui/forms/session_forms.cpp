#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/document/session_document.h"
#include "ui/forms/field_edit.h"
#include "ui/forms/field_form.h"
#include "ui/forms/field_notes.h"
#include "ui/settings/window_font.h"

namespace alidade::ui {

namespace {

struct Forms {
  Q_DECLARE_TR_FUNCTIONS(Forms)
};

QWidget* stacked(std::initializer_list<QWidget*> parts) {
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(5);
  for (QWidget* part : parts) layout->addWidget(part);
  layout->addStretch();
  return page;
}

/// The meaning of an empty σ of R0 depends on the use of the radius.
void sayWhatNoSigmaMeans(const SessionDocument& document, FieldEdit& sigma) {
  const auto say = [&document, &sigma] {
    const bool isKnown = document.session().model.radius == "known";
    sigma.setPlaceholderText(isKnown ? Forms::tr("0 (exact)") : Forms::tr("none"));
  };
  QObject::connect(&document, &SessionDocument::changed, &sigma, say);
  say();
}

}  // namespace

QWidget* createMeasurementForm(SessionDocument& document) {
  const QString mm = Forms::tr("mm");
  const QVector<Choice> circles = {{QStringLiteral("zenith"), Forms::tr("Zenith")},
                                   {QStringLiteral("elevation"), Forms::tr("Elevation")}};
  const QVector<Choice> planes = {{QStringLiteral("vertical"), Forms::tr("Vertical")},
                                  {QStringLiteral("square"), Forms::tr("Square")}};
  const QVector<Choice> relations = {{QStringLiteral("exact"), Forms::tr("Exact")},
                                     {QStringLiteral("planar"), Forms::tr("Planar")}};
  const QVector<Choice> radii = {{QStringLiteral("free"), Forms::tr("Free")},
                                 {QStringLiteral("common"), Forms::tr("Common")},
                                 {QStringLiteral("known"), Forms::tr("Known")}};
  const QVector<Choice> measurands = {{QStringLiteral("intersection"), Forms::tr("Δd")},
                                      {QStringLiteral("distance"), Forms::tr("Distance")}};
  auto* form = new FieldForm(
      document,
      {
          {"geometry.distance_mm", Forms::tr("Distance &L"), mm, Forms::tr("required"),
           Forms::tr("From the theodolite's centre to the plane of the arc")},
          {"geometry.sigma_distance_mm", Forms::tr("σ of L"), mm, Forms::tr("0 (exact)"),
           Forms::tr("Standard uncertainty of the distance; empty means exact")},
          {"geometry.radius_mm", Forms::tr("&Radius R0"), mm, Forms::tr("required"),
           Forms::tr("Nominal radius of the arc")},
          {"geometry.sigma_radius_mm",
           Forms::tr("σ of R0"),
           mm,
           {},
           Forms::tr("Standard uncertainty of the nominal radius. A known radius takes it into the fit, and "
                     "empty means exact; else R − R0 is a closure with it, and without it none")},
          {"model.radius",
           Forms::tr("R&adius is"),
           {},
           {},
           Forms::tr("Free: each arc has its own. Common: one for both arcs. Known: R0 with its σ takes part "
                     "as one more observation"),
           radii},
          {"geometry.vertical_circle",
           Forms::tr("Vert. c&ircle"),
           {},
           {},
           Forms::tr(
               "What the vertical circle reads: zenith angles grow downwards, elevation angles upwards"),
           circles},
          {"model.vertical_angle",
           Forms::tr("Relation"),
           {},
           {},
           Forms::tr("Exact: tan e = y/√(x²+L²), what a theodolite reads. Planar: tan e = y/L, as in the "
                     "published method"),
           relations},
          {"acceptance.coverage",
           Forms::tr("Covera&ge"),
           {},
           Forms::tr("0.95"),
           Forms::tr("Coverage probability of the expanded uncertainty U, between 0 and 1")},
          {"acceptance.tolerance_mm", Forms::tr("&Tolerance"), mm, Forms::tr("none"),
           Forms::tr("Largest acceptable intersection; without it there is no verdict")},
          {"acceptance.measurand",
           Forms::tr("Limits"),
           {},
           {},
           Forms::tr(
               "What the tolerance limits: the intersection Δd, which is the part in the plane of the arc "
               "of the distance of its centre from the axis, or that distance as a whole"),
           measurands},
          {"acceptance.reference_intersection_mm", Forms::tr("Reference"), mm, Forms::tr("none"),
           Forms::tr(
               "What the device was set to, where known; shown beside the result, never part of a fit")},
          {"acceptance.sigma_reference_mm", Forms::tr("σ of ref."), mm, Forms::tr("none"),
           Forms::tr("How well the reference is known (1σ). With it the reference is a closure, and may help "
                     "the diagnosis to tell causes apart; it never enters Δd")},
          {"geometry.plane",
           Forms::tr("Arc's plane"),
           {},
           {},
           Forms::tr(
               "Where the instrument stands above or below the axis, its pointing zero is inclined. "
               "Vertical: the plane of the arc is plumb all the same. Square: it is square to the zero"),
           planes},
      },
      2);
  sayWhatNoSigmaMeans(document, *form->findChild<FieldEdit*>(QStringLiteral("geometry.sigma_radius_mm")));
  return stacked({form});
}

QWidget* createInstrumentForm(SessionDocument& document) {
  const QString seconds = Forms::tr("″");
  const QVector<Choice> marks = {{{}, Forms::tr("Unstated")},
                                 {QStringLiteral("mark"), Forms::tr("A mark")},
                                 {QStringLiteral("normal"), Forms::tr("The normal")},
                                 {QStringLiteral("unknown"), Forms::tr("Not known")}};
  const QVector<Choice> zeros = {{{}, Forms::tr("Unstated")},
                                 {QStringLiteral("each"), Forms::tr("Each")},
                                 {QStringLiteral("one"), Forms::tr("One for all")}};
  return stacked({new FieldForm(
      document,
      {
          {"instrument.name", Forms::tr("Instr&ument"), {}, Forms::tr("model"), {}, {}, true},
          {"instrument.serial", Forms::tr("Serial no."), {}, {}, {}},
          {"geometry.pointing_zeros",
           Forms::tr("Pointing zeros"),
           {},
           {},
           Forms::tr(
               "Each: sighted anew in every position. One: sighted once for all, so that an error of it "
               "cancels in Δd"),
           zeros},
          {"geometry.zero_is",
           Forms::tr("Zeros sight"),
           {},
           {},
           Forms::tr("A mark: one fixed direction, so that zeros which differ show a drift or a knock. The "
                     "normal: that of the guideway, set anew in each position. Unstated: a mark where the "
                     "zeros agree within 30″"),
           marks},
          {"instrument.sigma_horizontal_arcsec", Forms::tr("σ ho&rizontal"), seconds, Forms::tr("2"),
           Forms::tr("Stated standard deviation of one horizontal reading")},
          {"instrument.sigma_vertical_arcsec", Forms::tr("σ vertical"), seconds, Forms::tr("2"),
           Forms::tr("Stated standard deviation of one vertical reading")},
          {"instrument.sigma_zero_arcsec", Forms::tr("σ of &zeros"), seconds, Forms::tr("as the circles"),
           Forms::tr("Standard uncertainty of one sighting of the pointing zeros α0 and β0")},
          {"instrument.sigma_slider_arcsec", Forms::tr("σ slider"), seconds, Forms::tr("5"),
           Forms::tr("Standard deviation of one slider reading")},
          {"instrument.line_of_sight_mm", Forms::tr("Line of sight e"), QStringLiteral("mm"),
           Forms::tr("not known"),
           Forms::tr(
               "Offset of the line of sight from the vertical axis, by the instrument check: e/D at the "
               "distance of this session adds to the known collimation")},
          {"instrument.sigma_line_of_sight_mm", Forms::tr("u of e"), QStringLiteral("mm"), Forms::tr("0"),
           Forms::tr("Standard uncertainty of the offset of the line of sight")},
          {"instrument.line_of_sight_correlation",
           Forms::tr("Correlation of e"),
           {},
           Forms::tr("0"),
           Forms::tr("Of the offset of the line of sight with the known collimation, −1 to 1: one fit found "
                     "both")},
          {"instrument.sigma_compensator_arcsec", Forms::tr("σ compensator"), seconds, Forms::tr("1"),
           Forms::tr("Setting accuracy of the compensator, by its data sheet; of use where the readings have "
                     "tilts, or say what the instrument corrected")},
          {"device.name", Forms::tr("Dev&ice"), {}, Forms::tr("simulator measured"), {}, {}, true},
          {"device.serial", Forms::tr("Serial no."), {}, {}, {}},
      },
      2)});
}

QWidget* createLaboratoryForm(SessionDocument& document) {
  return stacked({new FieldForm(
      document,
      {
          {"report.number",
           Forms::tr("Re&port no."),
           {},
           {},
           Forms::tr("Unique number of the report, printed on each of its pages")},
          {"report.authorised_by",
           Forms::tr("Au&thorised by"),
           {},
           {},
           Forms::tr("Who answers for the report")},
          {"report.laboratory", Forms::tr("&Laboratory"), {}, Forms::tr("name and address"), {}, {}, true},
          {"report.customer", Forms::tr("C&ustomer"), {}, Forms::tr("name and address"), {}, {}, true},
          {"report.rule_agreed_by",
           Forms::tr("Rule a&greed by"),
           {},
           Forms::tr("who, and where it is written"),
           Forms::tr("With whom the decision rule was agreed: accept only where |Δd| + U is within the "
                     "tolerance, reject only where |Δd| − U is beyond it"),
           {},
           true},
          {"instrument.certificate",
           Forms::tr("Certificate"),
           {},
           {},
           Forms::tr("Calibration certificate of the instrument, for the report")},
          {"geometry.distance_from",
           Forms::tr("L measured"),
           {},
           Forms::tr("how"),
           Forms::tr("How the distance was measured, and its traceability; for the report")},
          {"instrument.traceability",
           Forms::tr("Circles traceable"),
           {},
           Forms::tr("to"),
           Forms::tr("To which standards the circles are traceable, and through whom; for the report"),
           {},
           true},
      },
      2)});
}

QWidget* createSessionForm(SessionDocument& document) {
  auto* form = new FieldForm(
      document,
      {
          {"title", Forms::tr("T&itle"), {}, {}, {}, {}, true},
          {"operator", Forms::tr("Operator"), {}, {}, {}},
          {"place", Forms::tr("&Place"), {}, {}, {}},
          {"measured_on",
           Forms::tr("D&ate"),
           {},
           Forms::tr("YYYY-MM-DD"),
           Forms::tr("Day of the measurement")},
          {"environment.temperature_c",
           Forms::tr("&Temp."),
           Forms::tr("°C"),
           {},
           Forms::tr("Temperature of the device and of the air")},
          {"environment.sigma_temperature_c", Forms::tr("σ of temp."), Forms::tr("K"), Forms::tr("0 (exact)"),
           Forms::tr("Standard uncertainty of the temperature")},
          {"geometry.distance_expansion_ppm_per_k", Forms::tr("L expands"), Forms::tr("ppm/K"),
           Forms::tr("none"),
           Forms::tr("By how much L grows with each kelvin above 20 °C, for which it is stated; "
                     "empty where it is as measured at this temperature")},
          {"geometry.radius_expansion_ppm_per_k", Forms::tr("R0 expands"), Forms::tr("ppm/K"),
           Forms::tr("none"),
           Forms::tr("By how much R0 grows with each kelvin above 20 °C, for which it is "
                     "stated: 11.5 for steel")},
      },
      2);
  auto* notes = new FieldNotes(document, {.field = "notes"});
  notes->setObjectName(QStringLiteral("notes"));
  notes->setAccessibleName(Forms::tr("Notes"));
  layOutByFont(*notes, [notes] { notes->setFixedHeight(notes->fontMetrics().lineSpacing() * 2 + 14); });
  auto* caption = new QLabel(Forms::tr("Notes"));
  caption->setBuddy(notes);
  caption->setAlignment(Qt::AlignTop);
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(caption);
  layout->addWidget(notes, 1);
  return stacked({form, row});
}

}  // namespace alidade::ui
