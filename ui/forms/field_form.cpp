#include "ui/forms/field_form.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>

#include "core/session/session_fields.h"
#include "core/session/time_text.h"
#include "ui/forms/calendar_button.h"
#include "ui/forms/field_choice.h"
#include "ui/forms/field_edit.h"
#include "ui/settings/window_font.h"

namespace alidade::ui {

namespace {

/// The text in the language of the window; empty if `english` is null.
QString shown(const char* english) {
  return english ? QCoreApplication::translate("Forms", english) : QString();
}

}  // namespace

FieldForm::FieldForm(SessionDocument& document, std::span<const std::string_view> fields, int columns,
                     QWidget* parent)
    : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(5);
  int cell = 0;
  const auto toNextRow = [&] { cell = (cell + columns - 1) / columns * columns; };
  for (const std::string_view key : fields) {
    const SessionField& field = *sessionFieldNamed(key);
    if (field.fillsRow) toNextRow();
    const int row = cell / columns, column = 4 * (cell % columns);
    QWidget* entry = addEntry(document, field);
    auto* label = new QLabel(shown(field.caption));
    label->setBuddy(entry);
    grid->addWidget(label, row, column);
    grid->addWidget(entry, row, column + 1, 1, field.fillsRow ? 4 * columns - 2 : 1);
    if (field.unit) grid->addWidget(new QLabel(shown(field.unit)), row, column + 2);
    ++cell;
    if (field.fillsRow) toNextRow();
  }
  for (int column = 0; column < columns; ++column) {
    grid->setColumnStretch(4 * column + 1, 1);
    if (column > 0) grid->setColumnMinimumWidth(4 * column - 1, 8);
  }
}

QWidget* FieldForm::addEntry(SessionDocument& document, const SessionField& field) {
  const Place place{.field = std::string(field.key)};
  const QString accessible = shown(field.caption).remove(QLatin1Char('&'));
  QWidget* entry = nullptr;
  if (field.choices.empty()) {
    auto* line = new FieldEdit(document, place);
    line->setPlaceholderText(shown(field.whenEmpty));
    line->setHint(shown(field.help));
    if (isDay(field.key)) addCalendarButton(*line);
    entry = line;
  } else {
    QVector<Choice> choices;
    for (const WordChoice& choice : field.choices)
      choices.append({QString::fromUtf8(choice.word), shown(choice.caption)});
    auto* choice = new FieldChoice(document, place, choices);
    choice->setHint(shown(field.help));
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    entry = choice;
  }
  entry->setObjectName(QString::fromStdString(place.field));
  entry->setAccessibleName(field.unit ? QStringLiteral("%1 (%2)").arg(accessible, shown(field.unit))
                                      : accessible);
  layOutByFont(*entry,
               [entry, width = field.choices.empty() ? 60 : 84] { entry->setMinimumWidth(byFont(width)); });
  return entry;
}

}  // namespace alidade::ui
