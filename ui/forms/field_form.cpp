#include "ui/forms/field_form.h"

#include <QGridLayout>
#include <QLabel>

#include "ui/forms/field_edit.h"
#include "ui/settings/window_font.h"

namespace alidade::ui {

FieldForm::FieldForm(SessionDocument& document, const QVector<FormField>& fields, int columns,
                     QWidget* parent)
    : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(5);
  int cell = 0;
  const auto toNextRow = [&] { cell = (cell + columns - 1) / columns * columns; };
  for (const FormField& field : fields) {
    if (field.fillsRow) toNextRow();
    const int row = cell / columns, column = 4 * (cell % columns);
    QWidget* entry = addEntry(document, field);
    auto* label = new QLabel(field.caption);
    label->setBuddy(entry);
    grid->addWidget(label, row, column);
    grid->addWidget(entry, row, column + 1, 1, field.fillsRow ? 4 * columns - 2 : 1);
    if (!field.unit.isEmpty()) grid->addWidget(new QLabel(field.unit), row, column + 2);
    ++cell;
    if (field.fillsRow) toNextRow();
  }
  for (int column = 0; column < columns; ++column) {
    grid->setColumnStretch(4 * column + 1, 1);
    if (column > 0) grid->setColumnMinimumWidth(4 * column - 1, 8);
  }
}

QWidget* FieldForm::addEntry(SessionDocument& document, const FormField& field) {
  const Place place{.field = field.name};
  const QString accessible = QString(field.caption).remove(QLatin1Char('&'));
  QWidget* entry = nullptr;
  if (field.choices.isEmpty()) {
    auto* line = new FieldEdit(document, place);
    line->setPlaceholderText(field.placeholder);
    line->setHint(field.hint);
    entry = line;
  } else {
    auto* choice = new FieldChoice(document, place, field.choices);
    choice->setHint(field.hint);
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    entry = choice;
  }
  entry->setObjectName(QString::fromLatin1(field.name));
  entry->setAccessibleName(field.unit.isEmpty() ? accessible
                                                : QStringLiteral("%1 (%2)").arg(accessible, field.unit));
  layOutByFont(*entry,
               [entry, width = field.choices.isEmpty() ? 60 : 84] { entry->setMinimumWidth(byFont(width)); });
  return entry;
}

}  // namespace alidade::ui
