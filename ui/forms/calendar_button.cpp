#include "ui/forms/calendar_button.h"

#include <QAction>
#include <QCalendarWidget>
#include <QCoreApplication>
#include <QLineEdit>
#include <QMenu>
#include <QWidgetAction>

#include "core/session/time_text.h"
#include "ui/settings/theme.h"

namespace alidade::ui {

namespace {

QDate dayIn(const QLineEdit& line) {
  const std::string typed = completedDay(line.text().trimmed().toStdString());
  const QDate day = QDate::fromString(QString::fromStdString(typed), Qt::ISODate);
  return day.isValid() ? day : QDate::currentDate();
}

void openCalendar(QLineEdit& line) {
  auto* menu = new QMenu(&line);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  auto* calendar = new QCalendarWidget;
  calendar->setSelectedDate(dayIn(line));
  QObject::connect(calendar, &QCalendarWidget::activated, menu, [&line, menu](QDate day) {
    menu->close();
    line.setText(day.toString(Qt::ISODate));
    line.setModified(true);
    emit line.returnPressed();
  });
  QObject::connect(calendar, &QCalendarWidget::clicked, calendar, &QCalendarWidget::activated);
  auto* shown = new QWidgetAction(menu);
  shown->setDefaultWidget(calendar);
  menu->addAction(shown);
  menu->popup(line.mapToGlobal(line.rect().bottomLeft()));
  calendar->setFocus();
}

}  // namespace

void addCalendarButton(QLineEdit& line) {
  QAction* button = line.addAction(themeIcon(QStringLiteral("calendar")), QLineEdit::TrailingPosition);
  button->setToolTip(QCoreApplication::translate("CalendarButton", "Choose in a calendar"));
  QObject::connect(button, &QAction::triggered, &line, [&line] { openCalendar(line); });
}

}  // namespace alidade::ui
