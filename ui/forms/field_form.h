#pragma once

#include <QWidget>
#include <span>
#include <string_view>

namespace alidade {
struct SessionField;
}

namespace alidade::ui {

class SessionDocument;

/// Labelled entries for the `fields` of the session, `columns` entries in a row. A field with `fillsRow` has
/// a row of its own.
class FieldForm : public QWidget {
  Q_OBJECT

 public:
  FieldForm(SessionDocument& document, std::span<const std::string_view> fields, int columns,
            QWidget* parent = nullptr);

 private:
  QWidget* addEntry(SessionDocument& document, const SessionField& field);
};

/// The forms of the window, each for a part of the session.
QWidget* createMeasurementForm(SessionDocument& document);
QWidget* createInstrumentForm(SessionDocument& document);
QWidget* createSessionForm(SessionDocument& document);
QWidget* createLaboratoryForm(SessionDocument& document);

}  // namespace alidade::ui
