#pragma once

#include <QVector>
#include <QWidget>

#include "ui/forms/field_choice.h"

class QGridLayout;
class QLabel;

namespace alidade::ui {

/// One field of a form as the user sees it.
struct FormField {
  const char* name;              ///< in the session file
  QString caption;               ///< with a mnemonic
  QString unit;                  ///< shown after the entry
  QString placeholder;           ///< what an empty entry means
  QString hint;                  ///< tool tip
  QVector<Choice> choices = {};  ///< a list instead of a line
  bool fillsRow = false;         ///< for long texts: a row of its own
};

/// Labelled entries, `columns` to a row; those that fill a row have their own.
class FieldForm : public QWidget {
  Q_OBJECT

 public:
  FieldForm(SessionDocument& document, const QVector<FormField>& fields, int columns,
            QWidget* parent = nullptr);

 private:
  QWidget* addEntry(SessionDocument& document, const FormField& field);
};

/// The forms of the window, each for a part of the session.
QWidget* createMeasurementForm(SessionDocument& document);
QWidget* createInstrumentForm(SessionDocument& document);
QWidget* createSessionForm(SessionDocument& document);
QWidget* createLaboratoryForm(SessionDocument& document);

}  // namespace alidade::ui
