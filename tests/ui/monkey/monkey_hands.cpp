#include "tests/ui/monkey/monkey_hands.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <QSpinBox>
#include <QTest>
#include <QTreeWidget>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <utility>

#include "tests/ui/monkey/monkey_texts.h"
#include "tests/ui/support.h"
#include "ui/forms/field_edit.h"
#include "ui/main_window.h"
#include "ui/panels/model/effects_panel.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/readings/suspect_bar.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/settings/theme.h"
#include "ui/window/entry_column.h"

namespace alidade::ui {

namespace {

QString nameOf(const QObject* object) {
  if (!object) return QStringLiteral("nothing");
  const QString name = object->objectName();
  return QString::fromLatin1(object->metaObject()->className()) + (name.isEmpty() ? name : u' ' + name);
}

/// The deepest widget at a place; the window itself if there is none.
QWidget* widgetAt(QWidget& window, const QPoint& place) {
  QWidget* found = window.childAt(place);
  return found ? found : &window;
}

QString pointText(const QPoint& place) {
  return QStringLiteral("(%1, %2)").arg(place.x()).arg(place.y());
}

}  // namespace

void MonkeyHands::doAnything() {
  using Deed = void (MonkeyHands::*)();
  static const std::pair<int, Deed> deeds[] = {
      {20, &MonkeyHands::pressKey},     {20, &MonkeyHands::typeIntoCell},   {8, &MonkeyHands::typeIntoField},
      {16, &MonkeyHands::click},        {2, &MonkeyHands::openContextMenu}, {8, &MonkeyHands::pressButton},
      {3, &MonkeyHands::triggerAction}, {3, &MonkeyHands::paste},           {6, &MonkeyHands::editRows},
      {8, &MonkeyHands::undoOrRedo},    {6, &MonkeyHands::turnPage},        {3, &MonkeyHands::tickEffect},
      {4, &MonkeyHands::useSuspect},    {1, &MonkeyHands::useFiles},        {2, &MonkeyHands::addPosition},
      {1, &MonkeyHands::changeLook},    {4, &MonkeyHands::hover},           {8, &MonkeyHands::wait}};
  int whole = 0;
  for (const auto& [weight, deed] : deeds) whole += weight;
  int left = m_chance.below(whole);
  for (const auto& [weight, deed] : deeds)
    if ((left -= weight) < 0) return (this->*deed)();
}

/// The window itself, or an open dialog.
QWidget* MonkeyHands::anyWindow() const {
  QList<QWidget*> windows;
  for (QWidget* widget : QApplication::topLevelWidgets())
    if (widget->isVisible() && (widget->windowType() == Qt::Window || widget->windowType() == Qt::Dialog))
      windows.append(widget);
  std::sort(windows.begin(), windows.end(),
            [](const QWidget* a, const QWidget* b) { return nameOf(a) < nameOf(b); });
  return windows.isEmpty() ? nullptr : m_chance.of(windows);
}

ReadingsTable* MonkeyHands::table() const {
  return m_window->currentTable();
}

void MonkeyHands::pressKey() {
  static const Qt::Key often[] = {Qt::Key_Tab,       Qt::Key_Backtab,  Qt::Key_Return, Qt::Key_Up,
                                  Qt::Key_Down,      Qt::Key_Left,     Qt::Key_Right,  Qt::Key_Delete,
                                  Qt::Key_F2,        Qt::Key_Escape,   Qt::Key_Space,  Qt::Key_Home,
                                  Qt::Key_End,       Qt::Key_PageDown, Qt::Key_F7,     Qt::Key_F8,
                                  Qt::Key_Backspace, Qt::Key_PageUp,   Qt::Key_Insert, Qt::Key_F10};
  static const Qt::KeyboardModifiers modifiers[] = {
      Qt::NoModifier,      Qt::NoModifier,    Qt::NoModifier,
      Qt::ControlModifier, Qt::ShiftModifier, Qt::ControlModifier | Qt::ShiftModifier,
      Qt::AltModifier};
  QWidget* focus = QApplication::focusWidget();
  QWidget* target = focus ? focus : m_window;
  const Qt::KeyboardModifiers with = m_chance.of(modifiers);
  if (m_chance.oneIn(2)) {
    const Qt::Key key = m_chance.of(often);
    m_say(QKeySequence(with.toInt() | key).toString() + QStringLiteral(" into ") + nameOf(target));
    return QTest::keyClick(target, key, with);
  }
  const char character = m_chance.of(QStringLiteral("0123456789 .-abcefghinstvxyz")).toLatin1();
  m_say(QStringLiteral("“%1” with %2 into %3")
            .arg(QLatin1Char(character))
            .arg(with.toInt(), 0, 16)
            .arg(nameOf(target)));
  QTest::keyClick(target, character, with);
}

/// Usually the current text with a slip, sometimes any text.
void MonkeyHands::typeIntoCell() {
  ReadingsTable* table = this->table();
  if (!table) return m_say(QStringLiteral("no table to type into"));
  constexpr ReadingColumn columns[] = {
      ReadingColumn::Horizontal, ReadingColumn::Vertical, ReadingColumn::Horizontal,
      ReadingColumn::Vertical,   ReadingColumn::Point,    ReadingColumn::Face,
      ReadingColumn::Round,      ReadingColumn::Slider,   ReadingColumn::Note};
  const ReadingColumn column = m_chance.of(columns);
  const int row = m_chance.below(table->readings().rowCount());
  table->selectCell(row, column);
  const QString present = table->currentIndex().data(Qt::EditRole).toString();
  const QString text = m_chance.oneIn(4) ? anyText(m_chance) : slipped(present, m_chance);
  m_say(QStringLiteral("type “%1” into row %2, column %3").arg(text).arg(row).arg(static_cast<int>(column)));
  typeInto(*table, text,
           m_chance.oneIn(6)   ? Qt::Key_Escape
           : m_chance.oneIn(2) ? Qt::Key_Tab
                               : Qt::Key_Return);
}

void MonkeyHands::typeIntoField() {
  QList<QLineEdit*> lines;
  for (QLineEdit* line : m_window->findChildren<QLineEdit*>())
    if (line->isVisible() && line->isEnabled()) lines.append(line);
  if (lines.isEmpty()) return m_say(QStringLiteral("no line to type into"));
  QLineEdit* line = m_chance.of(lines);
  const QString text = m_chance.oneIn(2) ? slipped(line->text(), m_chance) : anyText(m_chance);
  m_say(QStringLiteral("type “%1” into %2").arg(text, nameOf(line)));
  line->setFocus();
  line->selectAll();
  typeInto(*line, text, m_chance.oneIn(5) ? Qt::Key_Escape : Qt::Key_Return);
}

void MonkeyHands::click() {
  QWidget* window = anyWindow();
  if (!window) return m_say(QStringLiteral("nothing to click"));
  const QPoint place(m_chance.below(window->width()), m_chance.below(window->height()));
  QWidget* target = widgetAt(*window, place);
  const QPoint there = target->mapFrom(window, place);
  const Qt::KeyboardModifier with =
      m_chance.of(std::array{Qt::NoModifier, Qt::NoModifier, Qt::ControlModifier, Qt::ShiftModifier});
  const bool twice = m_chance.oneIn(5);
  m_say(QStringLiteral("click %1 at %2 %3")
            .arg(nameOf(target), pointText(place), QLatin1String(twice ? "twice" : "once")));
  if (twice) return QTest::mouseDClick(target, Qt::LeftButton, with, there);
  QTest::mouseClick(target, m_chance.oneIn(10) ? Qt::MiddleButton : Qt::LeftButton, with, there);
}

void MonkeyHands::openContextMenu() {
  QWidget* window = anyWindow();
  if (!window) return m_say(QStringLiteral("no place for a menu"));
  const QPoint place(m_chance.below(window->width()), m_chance.below(window->height()));
  QWidget* target = widgetAt(*window, place);
  m_say(QStringLiteral("menu of %1 at %2").arg(nameOf(target), pointText(place)));
  QContextMenuEvent event(QContextMenuEvent::Mouse, target->mapFrom(window, place),
                          window->mapToGlobal(place));
  QApplication::sendEvent(target, &event);
}

void MonkeyHands::pressButton() {
  const QWidget* window = anyWindow();
  QList<QAbstractButton*> buttons;
  if (window)
    for (QAbstractButton* button : window->findChildren<QAbstractButton*>())
      if (button->isVisible() && button->isEnabled()) buttons.append(button);
  if (buttons.isEmpty()) return m_say(QStringLiteral("no button to press"));
  QAbstractButton* button = m_chance.of(buttons);
  m_say(QStringLiteral("press %1 “%2”").arg(nameOf(button), button->text()));
  button->setFocus();
  QTest::keyClick(button, Qt::Key_Space);
}

void MonkeyHands::triggerAction() {
  QList<QAction*> actions;
  for (QAction* action : m_window->findChildren<QAction*>())
    if (action->isEnabled() && !action->menu() && !action->isSeparator()) actions.append(action);
  QAction* action = m_chance.of(actions);
  m_say(QStringLiteral("menu “%1”").arg(action->text()));
  action->trigger();
}

void MonkeyHands::paste() {
  ReadingsTable* table = this->table();
  if (!table) return m_say(QStringLiteral("no table to paste into"));
  const QString text = anyTable(m_window->document().session(), m_chance);
  QApplication::clipboard()->setText(text);
  constexpr ReadingColumn columns[] = {ReadingColumn::Horizontal, ReadingColumn::Horizontal,
                                       ReadingColumn::Vertical, ReadingColumn::Point, ReadingColumn::Note};
  table->selectCell(m_chance.below(table->readings().rowCount()), m_chance.of(columns));
  m_say(QStringLiteral("paste %1 lines: “%2…”").arg(text.count(u'\n') + 1).arg(text.left(60)));
  table->paste();
}

void MonkeyHands::editRows() {
  ReadingsTable* table = this->table();
  if (!table) return m_say(QStringLiteral("no rows to edit"));
  constexpr void (ReadingsTable::*edits[])() = {
      &ReadingsTable::insertAbove,    &ReadingsTable::deleteSelected, &ReadingsTable::toggleExcluded,
      &ReadingsTable::toggleExcluded, &ReadingsTable::clearCells,     &ReadingsTable::cut};
  const int rows = table->readings().rowCount(), first = m_chance.below(rows);
  const int last = std::min(rows - 1, first + m_chance.below(m_chance.oneIn(8) ? rows : 3));
  table->clearSelection();
  table->selectCell(first, ReadingColumn::Horizontal);
  table->selectionModel()->select(
      {table->model()->index(first, 0), table->model()->index(last, table->model()->columnCount() - 1)},
      QItemSelectionModel::ClearAndSelect);
  const int which = m_chance.below(static_cast<int>(std::size(edits)));
  m_say(QStringLiteral("edit %1 of rows %2 to %3").arg(which).arg(first).arg(last));
  (table->*edits[which])();
}

void MonkeyHands::undoOrRedo() {
  const int steps = m_chance.oneIn(10) ? m_chance.between(10, 60) : m_chance.between(1, 3);
  const bool back = m_chance.below(5) < 3;
  m_say(QStringLiteral("%1 %2 times").arg(QLatin1String(back ? "undo" : "redo")).arg(steps));
  for (int i = 0; i < steps; ++i) back ? m_window->undo() : m_window->redo();
}

void MonkeyHands::turnPage() {
  const QList<QTabWidget*> tabs = m_window->findChildren<QTabWidget*>();
  QTabWidget* chosen = m_chance.of(tabs);
  const int page = m_chance.below(chosen->count());
  m_say(QStringLiteral("page %1 of %2").arg(page).arg(nameOf(chosen)));
  if (chosen->isTabVisible(page)) chosen->setCurrentIndex(page);
}

void MonkeyHands::tickEffect() {
  auto* list = m_window->findChild<EffectsPanel*>()->findChild<QTreeWidget*>();
  QTreeWidgetItem* item = list->topLevelItem(m_chance.below(list->topLevelItemCount()));
  m_say(QStringLiteral("tick “%1”").arg(item->text(0)));
  item->setCheckState(0, item->checkState(0) == Qt::Checked ? Qt::Unchecked : Qt::Checked);
}

void MonkeyHands::useSuspect() {
  SuspectBar* bar = m_window->entries().suspects();
  const int way = m_chance.below(4);
  m_say(QStringLiteral("suspect: way %1").arg(way));
  if (way == 0)
    bar->useProposal(m_chance.below(3));
  else if (way == 1)
    bar->exclude();
  else
    bar->goToNext();
}

void MonkeyHands::writeReadingsFile() const {
  QFile file(
      m_folder.filePath(m_chance.oneIn(2) ? QStringLiteral("readings.csv") : QStringLiteral("readings.gsi")));
  if (file.open(QIODevice::WriteOnly)) file.write(anyReadingsFile(m_chance));
}

void MonkeyHands::useFiles() {
  FileFlow& files = m_window->files();
  const int way = m_chance.below(8);
  const char* ways[] = {"save", "save as", "import", "new", "report"};
  m_say(QLatin1String(way < 5 ? ways[way] : "open"));
  if (way == 2) writeReadingsFile();
  if (way == 0) files.save();
  if (way == 1) files.saveAs();
  if (way == 2) files.importReadings();
  if (way == 3) files.startNew();
  if (way == 4) files.exportReport();
  if (way > 4) files.open();
}

void MonkeyHands::addPosition() {
  const int axis = m_chance.oneIn(2) ? 0 : 180;
  m_say(QStringLiteral("add position at %1°").arg(axis));
  m_window->addPosition(axis);
}

void MonkeyHands::changeLook() {
  if (m_chance.oneIn(2)) {
    m_say(QStringLiteral("another theme"));
    return applyTheme(m_chance.of(std::array{Theme::System, Theme::Light, Theme::Dark}));
  }
  const QSize size(m_chance.between(200, 1600), m_chance.between(150, 1000));
  m_say(QStringLiteral("resize to %1 × %2").arg(size.width()).arg(size.height()));
  m_window->resize(size);
}

/// Moves the mouse, or turns its wheel.
void MonkeyHands::hover() {
  QWidget* window = anyWindow();
  if (!window) return m_say(QStringLiteral("nothing to hover over"));
  const QPoint place(m_chance.below(window->width()), m_chance.below(window->height()));
  QWidget* target = widgetAt(*window, place);
  const QPoint there = target->mapFrom(window, place);
  m_say(QStringLiteral("hover over %1 at %2").arg(nameOf(target), pointText(place)));
  if (m_chance.oneIn(2)) return QTest::mouseMove(target, there);
  QWheelEvent event(there, target->mapToGlobal(QPointF(there)), {}, {0, m_chance.oneIn(2) ? 120 : -120},
                    Qt::NoButton, m_chance.oneIn(3) ? Qt::ControlModifier : Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(target, &event);
}

/// Lets jobs end at any time.
void MonkeyHands::wait() {
  const int milliseconds = m_chance.oneIn(20) ? 600 : m_chance.below(30);
  m_say(QStringLiteral("wait %1 ms").arg(milliseconds));
  QTest::qWait(milliseconds);
}

}  // namespace alidade::ui
