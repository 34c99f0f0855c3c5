#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "core/session/session_fields.h"
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

/// Shows what an empty σ of R0 means: exact if the radius is known, else no value.
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
  auto* form = new FieldForm(document, measurementForm, 2);
  sayWhatNoSigmaMeans(document, *form->findChild<FieldEdit*>(QStringLiteral("geometry.sigma_radius_mm")));
  return stacked({form});
}

QWidget* createInstrumentForm(SessionDocument& document) {
  return stacked({new FieldForm(document, instrumentForm, 2)});
}

QWidget* createLaboratoryForm(SessionDocument& document) {
  return stacked({new FieldForm(document, laboratoryForm, 2)});
}

QWidget* createSessionForm(SessionDocument& document) {
  auto* form = new FieldForm(document, sessionForm, 2);
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
