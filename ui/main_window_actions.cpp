#include "ui/main_window_actions.h"

#include <QAbstractItemView>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

#include "core/session/entry.h"
#include "ui/commands/change_positions.h"
#include "ui/commands/change_session.h"
#include "ui/connection/instrument_desk.h"
#include "ui/dialogs/command_palette.h"
#include "ui/dialogs/export_flow.h"
#include "ui/entry/entry_guide.h"
#include "ui/entry/readings_finder.h"
#include "ui/help/help_topics.h"
#include "ui/help/help_window.h"
#include "ui/main_window.h"
#include "ui/panels/journal/change_reason_bar.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/readings/suspect_bar.h"
#include "ui/settings/recent_files.h"
#include "ui/settings/theme.h"
#include "ui/settings/window_font.h"
#include "ui/text/position_text.h"
#include "ui/text/visible_text.h"
#include "ui/window/entry_column.h"
#include "ui/window/result_column.h"
#include "ui/window/side_windows.h"

namespace alidade::ui {

namespace {

constexpr int widestPath = 600;  // pixels

template <typename Call>
QAction* addTo(QMenu& menu, const char* icon, const QString& text, const QKeySequence& keys, QObject* context,
               Call call) {
  QAction* action = menu.addAction(text);
  if (icon) action->setIcon(themeIcon(QString::fromLatin1(icon)));
  action->setShortcut(keys);
  action->setIconVisibleInMenu(icon != nullptr);
  QObject::connect(action, &QAction::triggered, context, call);
  return action;
}

}  // namespace

WindowActions::WindowActions(MainWindow& window, Dialogs& dialogs)
    : QObject(&window), m_window(window), m_dialogs(dialogs) {
  auto* bar = new QToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setIconSize({20, 20});
  bar->setMovable(false);
  window.addToolBar(bar);
  createFileMenu(*bar);
  bar->addSeparator();
  createEditMenu(*bar);
  createViewMenu();
  createInstrumentMenu();
  createToolsMenu();
  createHelpMenu(dialogs);
}

void WindowActions::createFileMenu(QToolBar& bar) {
  FileFlow& files = m_window.files();
  QMenu& menu = *m_window.menuBar()->addMenu(tr("&File"));
  bar.addAction(addTo(menu, "new", tr("&New"), QKeySequence::New, this, [&files] { files.startNew(); }));
  addTo(menu, nullptr, tr("New &from This Session"), QKeySequence(tr("Ctrl+Shift+N")), this,
        [&files] { files.startNext(); });
  bar.addAction(addTo(menu, "open", tr("&Open…"), QKeySequence::Open, this, [&files] { files.open(); }));
  QMenu* recent = menu.addMenu(tr("Open &Recent"));
  recent->setToolTipsVisible(true);
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecentMenu(*recent); });
  fillRecentMenu(*recent);
  addTo(menu, nullptr, tr("&Import Readings…"), QKeySequence(tr("Ctrl+Shift+I")), this,
        [&files] { files.importReadings(); });
  addTo(menu, nullptr, tr("Import from Clip&board…"), {}, this, [&files] { files.importClipboard(); });
  addTo(menu, nullptr, tr("Reco&ver Unsaved Changes…"), {}, this, [this] {
    if (!m_window.offerRecovery())
      m_window.statusBar()->showMessage(tr("There are no unsaved changes to recover"));
  });
  menu.addSeparator();
  bar.addAction(addTo(menu, "save", tr("&Save"), QKeySequence::Save, this, [&files] { files.save(); }));
  addTo(menu, nullptr, tr("Save &As…"), QKeySequence(tr("Ctrl+Shift+S")), this, [&files] { files.saveAs(); });
  QAction* revert = addTo(menu, nullptr, tr("Rever&t"), {}, this, [&files] { files.revert(); });
  const SessionDocument& document = m_window.document();
  const auto mayRevert = [revert, &document] {
    revert->setEnabled(document.isModified() && !document.path().isEmpty());
  };
  connect(&document, &SessionDocument::identityChanged, revert, mayRevert);
  mayRevert();
  addTo(menu, nullptr, tr("Sea&l…"), {}, this, [&files] { files.seal(); });
  menu.addSeparator();
  bar.addAction(addTo(menu, "report", tr("&Export Acceptance Report…"), QKeySequence(tr("Ctrl+E")), this,
                      [&files] { files.exportReport(); }));
  addExportMenu(menu);
  addTo(menu, nullptr, tr("Print Previe&w…"), {}, this, [&files] { files.previewReport(); });
  addTo(menu, nullptr, tr("&Print…"), QKeySequence::Print, this, [&files] { files.printReport(); });
  menu.addSeparator();
  addTo(menu, nullptr, tr("&Close"), QKeySequence(tr("Ctrl+W")), this, [this] {
    if (m_window.files().startNew()) m_window.showStart();
  });
  addTo(menu, nullptr, tr("&Quit"), QKeySequence(tr("Ctrl+Q")), this, [this] { m_window.close(); });
}

/// Adds the exports for other programs.
void WindowActions::addExportMenu(QMenu& menu) {
  QMenu& exports = *menu.addMenu(tr("E&xport"));
  const std::pair<QString, bool (ExportFlow::*)()> kinds[] = {
      {tr("&Readings (CSV)…"), &ExportFlow::exportReadings},
      {tr("Re&siduals (CSV)…"), &ExportFlow::exportResiduals},
      {tr("R&esult (JSON)…"), &ExportFlow::exportResult},
      {tr("&Gap (JSON)…"), &ExportFlow::exportGap},
      {tr("&Budget (CSV)…"), &ExportFlow::exportBudget}};
  for (const auto& [text, call] : kinds)
    addTo(exports, nullptr, text, {}, this, [this, call = call] { (m_window.exports().*call)(); });
  addTo(exports, nullptr, tr("&Calibration Certificate (DCC)…"), {}, this,
        [this] { m_window.files().exportCertificate(); });
}

void WindowActions::fillRecentMenu(QMenu& menu) {
  menu.clear();
  int number = 0;
  for (const QString& path : RecentFiles::existing()) {
    const QString name = visibleLine(QDir::toNativeSeparators(path));
    QString shown = menu.fontMetrics().elidedText(name, Qt::ElideMiddle, widestPath);
    shown.replace(QLatin1Char('&'), QStringLiteral("&&"));
    QAction* action = menu.addAction(QStringLiteral("&%1  %2").arg(++number % 10).arg(shown));
    action->setToolTip(tipText(path));
    connect(action, &QAction::triggered, this, [this, path] { m_window.files().open(path); });
  }
  if (number == 0) menu.addAction(tr("No files yet"))->setEnabled(false);
  menu.addSeparator();
  QAction* forget = menu.addAction(tr("&Clear This List"));
  forget->setEnabled(number > 0);
  connect(forget, &QAction::triggered, this, [] { RecentFiles::clear(); });
}

void WindowActions::createEditMenu(QToolBar& bar) {
  QMenu& menu = *m_window.menuBar()->addMenu(tr("&Edit"));
  QUndoStack& stack = m_window.document().undoStack();
  QAction* undo = addTo(menu, "undo", tr("&Undo"), QKeySequence::Undo, this, [this] { m_window.undo(); });
  QAction* redo = addTo(menu, "redo", tr("&Redo"), QKeySequence::Redo, this, [this] { m_window.redo(); });
  redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  undo->setEnabled(false);
  redo->setEnabled(false);
  connect(&stack, &QUndoStack::canUndoChanged, undo, &QAction::setEnabled);
  connect(&stack, &QUndoStack::canRedoChanged, redo, &QAction::setEnabled);
  connect(&stack, &QUndoStack::undoTextChanged, undo, [undo](const QString& text) {
    undo->setText(text.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(menuText(text)));
  });
  connect(&stack, &QUndoStack::redoTextChanged, redo, [redo](const QString& text) {
    redo->setText(text.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(menuText(text)));
  });
  menu.addSeparator();
  QAction* cut =
      addTo(menu, nullptr, tr("Cu&t"), QKeySequence::Cut, this, [this] { useClipboard(Clipboard::Cut); });
  QAction* copy =
      addTo(menu, nullptr, tr("&Copy"), QKeySequence::Copy, this, [this] { useClipboard(Clipboard::Copy); });
  QAction* paste = addTo(menu, nullptr, tr("&Paste"), QKeySequence::Paste, this,
                         [this] { useClipboard(Clipboard::Paste); });
  addTo(menu, nullptr, tr("Paste as Readings…"), QKeySequence(tr("Ctrl+Shift+V")), this,
        [this] { m_window.files().importClipboard(); });
  addTo(menu, nullptr, tr("Select &All"), QKeySequence::SelectAll, this, [this] { selectAll(); });
  menu.addSeparator();
  addTo(menu, nullptr, tr("&Find…"), QKeySequence::Find, this,
        [this] { m_window.entries().finder().find(); });
  for (const bool forward : {true, false})
    addTo(menu, nullptr, forward ? tr("Find Next") : tr("Find Previous"),
          forward ? QKeySequence(Qt::Key_F3) : QKeySequence(Qt::SHIFT | Qt::Key_F3), this,
          [this, forward] { m_window.entries().finder().findAgain(forward); });
  menu.addSeparator();
  const auto onTable = [this](void (ReadingsTable::*call)()) {
    return [this, call] {
      m_window.commitPending();
      if (ReadingsTable* table = m_window.currentTable()) (table->*call)();
    };
  };
  QAction* insert = addTo(menu, "insert", tr("&Insert Reading Above"), QKeySequence(tr("Ctrl+I")), this,
                          onTable(&ReadingsTable::insertAbove));
  QAction* remove = addTo(menu, "delete", tr("&Delete Readings"), QKeySequence(tr("Ctrl+-")), this,
                          onTable(&ReadingsTable::deleteSelected));
  QAction* exclude =
      addTo(menu, "exclude", tr("E&xclude or Use\tSpace"), {}, this, onTable(&ReadingsTable::toggleExcluded));
  QAction* clear =
      addTo(menu, nullptr, tr("C&lear Cells\tDel"), {}, this, onTable(&ReadingsTable::clearCells));
  exclude->setToolTip(tr("Exclude or use the selected readings (Space)"));
  m_tableActions = {cut, copy, paste, insert, remove, exclude, clear};
  addSuspectActions(menu);
  menu.addSeparator();
  addEntryActions(menu);
  addPositionActions(menu);
  menu.addSeparator();
  addTo(menu, nullptr, tr("Pr&eferences…"), QKeySequence(tr("Ctrl+,")), this, [this] {
    m_window.commitPending();
    m_dialogs.askPreferences();
  });
  bar.addActions({undo, redo});
  bar.addSeparator();
  bar.addActions({insert, remove, exclude});
}

/// Adds three actions. The first is enabled if a reading looks misread, the second if a correction is
/// proposed, the third if a recorded entry was just changed.
void WindowActions::addSuspectActions(QMenu& menu) {
  menu.addSeparator();
  SuspectBar* suspects = m_window.entries().suspects();
  QAction* next = addTo(menu, nullptr, tr("&Next Misread Reading"), QKeySequence(Qt::Key_F7), this,
                        [suspects] { suspects->goToNext(); });
  QAction* use = addTo(menu, nullptr, tr("Use Proposed Readin&g"), QKeySequence(Qt::Key_F8), this,
                       [suspects] { suspects->useProposal(); });
  const auto enable = [suspects, next, use] {
    next->setEnabled(suspects->current());
    use->setEnabled(suspects->hasProposal());
  };
  connect(suspects, &SuspectBar::suspectsChanged, next, enable);
  enable();
  m_tableActions << next << use;
  ChangeReasonBar* reason = m_window.entries().changeReason();
  QAction* state =
      addTo(menu, nullptr, tr("State Reason for C&hange"), QKeySequence(tr("Ctrl+R")), this, [this, reason] {
        m_window.commitPending();
        reason->start();
      });
  state->setEnabled(false);
  connect(reason, &ChangeReasonBar::askingChanged, state, &QAction::setEnabled);
}

/// Adds the actions for further rows (return run, another round), and for moving to an entry.
void WindowActions::addEntryActions(QMenu& menu) {
  QMenu* rows = menu.addMenu(tr("Add Ro&ws"));
  const std::pair<QString, FurtherRows> ways[] = {
      {tr("Re&turn Run"), FurtherRows::WayBack},
      {tr("Return Run in Other &Face"), FurtherRows::WayBackInTwo},
      {tr("Another &Round"), FurtherRows::AnotherRound}};
  for (const auto& [text, which] : ways)
    addTo(*rows, nullptr, text, {}, this, [this, way = which] {
      m_window.commitPending();
      if (ReadingsTable* table = m_window.currentTable()) table->layOut(way);
    });
  m_tableActions << rows->menuAction();
  menu.addSeparator();
  addTo(menu, nullptr, tr("To Next Entr&y"), QKeySequence(Qt::Key_F6), this,
        [this] { m_window.entry().goToNextEntry(); });
  for (const auto& [axisDeg, keys] : {std::pair(0, tr("Alt+0")), std::pair(180, tr("Alt+1"))})
    addTo(menu, nullptr, tr("Readings at %1°").arg(axisDeg), QKeySequence(keys), this,
          [this, axis = axisDeg] { m_window.entry().goToAxis(axis); });
}

/// Adds an action for each axis angle: it adds the missing position, or a repeat if 0° and 180° exist.
void WindowActions::addPositionActions(QMenu& menu) {
  menu.addSeparator();
  const SessionDocument& document = m_window.document();
  for (const int axisDeg : {0, 180}) {
    QAction* action = addTo(menu, nullptr, {}, {}, this, [this, axisDeg] { m_window.addPosition(axisDeg); });
    action->setObjectName(QStringLiteral("add position %1").arg(axisDeg));
    const auto offer = [&document, action, axisDeg] {
      const bool isThere = hasPosition(document.session(), axisDeg);
      action->setText((isThere ? tr("Measure %1° Again") : tr("Add Position at %1°")).arg(axisDeg));
      action->setEnabled(mayAddPosition(document.session(), axisDeg));
    };
    connect(&document, &SessionDocument::changed, action, offer);
    offer();
  }
  QAction* remove = addTo(menu, nullptr, tr("Delete Position"), {}, this, [this] { removePosition(); });
  QAction* move = addTo(menu, nullptr, {}, {}, this, [this] { m_window.entries().moveReadings(); });
  m_tableActions << move;
  connect(&menu, &QMenu::aboutToShow, this, [this, &document, remove, move] {
    const auto* tabs = m_window.findChild<PositionTabs*>();
    const auto& positions = document.session().positions;
    const auto at = static_cast<std::size_t>(std::max(0, tabs->currentIndex()));
    const bool isThere = m_window.currentTable() != nullptr;
    remove->setEnabled(isThere);
    remove->setText(isThere ? tr("Delete Position %1").arg(menuText(positionText(document.session(), at)))
                            : tr("Delete Position"));
    move->setEnabled(isThere && positions.size() > 1);
    move->setText(move->isEnabled()
                      ? tr("Move Readings to %1")
                            .arg(menuText(positionText(document.session(), (at + 1) % positions.size())))
                      : tr("Move Readings"));
  });
  move->setText(tr("Move Readings"));
}

/// Removes the current position; asks first if the position has typed sightings.
void WindowActions::removePosition() {
  m_window.commitPending();
  const Session& session = m_window.document().session();
  const PositionTabs& tabs = m_window.entries().positions();
  if (!tabs.currentTable()) return;
  const auto at = static_cast<std::size_t>(tabs.currentIndex());
  const std::size_t typed = typedSightings(session.positions.at(at));
  if (typed == 0 || m_dialogs.askDeletePosition(positionText(session, at), typed))
    ui::removePosition(m_window.document(), at);
}

void WindowActions::attachTo(ReadingsTable* table) const {
  table->addActions(m_tableActions);
  table->setContextMenuPolicy(Qt::ActionsContextMenu);
}

/// Applies the clipboard action to the focused text or table, otherwise to the readings.
void WindowActions::useClipboard(Clipboard way) {
  QWidget* focus = QApplication::focusWidget();
  const auto apply = [way](auto& target) {
    if (way == Clipboard::Cut) target.cut();
    if (way == Clipboard::Copy) target.copy();
    if (way == Clipboard::Paste) target.paste();
  };
  if (auto* line = qobject_cast<QLineEdit*>(focus)) {
    apply(*line);
  } else if (auto* text = qobject_cast<QPlainTextEdit*>(focus)) {
    apply(*text);
  } else if (auto* label = qobject_cast<QLabel*>(focus); label && label->hasSelectedText()) {
    if (way == Clipboard::Copy) QApplication::clipboard()->setText(label->selectedText());
  } else if (auto* own = qobject_cast<EntryTable*>(focus)) {
    apply(*own);
  } else if (ReadingsTable* table = m_window.currentTable()) {
    apply(*table);
  }
}

/// Selects everything in the focused text or table, otherwise in the readings.
void WindowActions::selectAll() {
  QWidget* focus = QApplication::focusWidget();
  if (auto* line = qobject_cast<QLineEdit*>(focus)) return line->selectAll();
  if (auto* text = qobject_cast<QPlainTextEdit*>(focus)) return text->selectAll();
  auto* view = qobject_cast<QAbstractItemView*>(focus);
  if (!view) view = m_window.currentTable();
  if (!view) return;
  view->setFocus();
  view->selectAll();
}

void WindowActions::createViewMenu() {
  QMenu& menu = *m_window.menuBar()->addMenu(tr("&View"));
  for (const ReadingColumnInfo& info : allReadingColumns()) {
    if (!info.menuText) continue;
    QAction* action = menu.addAction(QCoreApplication::translate("ReadingColumn", info.menuText));
    action->setCheckable(true);
    action->setStatusTip(tr("A column that the session uses is always shown"));
    connect(action, &QAction::toggled, this,
            [this, which = info.column](bool shown) { m_window.setColumnShown(which, shown); });
  }
  addUnitActions(menu);
  addPageActions(menu);
  addEnlargeAction(menu);
  menu.addSeparator();
  addTo(menu, nullptr, tr("Large D&isplay"), QKeySequence(Qt::Key_F9), this,
        [this] { m_window.entry().toggleLargeDisplay(); });
  menu.addSeparator();
  addTo(menu, nullptr, tr("&Larger Font"), QKeySequence(tr("Ctrl+Alt++")), this,
        [] { applyFont(resized(rememberedFont(), 1)); });
  addTo(menu, nullptr, tr("S&maller Font"), QKeySequence(tr("Ctrl+Alt+-")), this,
        [] { applyFont(resized(rememberedFont(), -1)); });
}

/// Adds the choice of the instrument's unit, which applies to shown angles and typed bare numbers.
void WindowActions::addUnitActions(QMenu& menu) {
  SessionDocument& document = m_window.document();
  QMenu* units = menu.addMenu(tr("A&ngles in"));
  auto* group = new QActionGroup(this);
  const std::pair<QString, const char*> choices[] = {
      {tr("Degrees, &Minutes, Seconds"), "dms"}, {tr("&Decimal Degrees"), "degrees"}, {tr("&Gon"), "gon"}};
  for (const auto& [text, unit] : choices) {
    QAction* action = group->addAction(text);
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, &document, text = unit] {
      m_window.commitPending();
      changeField(document, {.field = "instrument.angle_unit"}, text);
    });
    const auto show = [action, &document, own = circleUnitEntry(unit)] {
      action->setChecked(circleUnitOf(document.session()) == *own);
    };
    connect(&document, &SessionDocument::changed, action, show);
    show();
  }
  units->addActions(group->actions());
}

/// Adds an action with a shortcut for every page; hidden pages are disabled.
void WindowActions::addPageActions(QMenu& menu) {
  menu.addSeparator();
  for (const PageInfo& info : allPages()) {
    const auto [tabs, page] = m_window.results().tab(info.id);
    const QKeySequence keys(QString::fromLatin1(info.keys));
    QAction* action = addTo(menu, nullptr, tabs->tabText(page), keys, this, [this, id = info.id] {
      m_window.hideStart();
      if (m_window.results().tab(id).first->isHidden()) m_enlarge->setChecked(false);
      m_window.results().showPage(id);
    });
    connect(&menu, &QMenu::aboutToShow, action, [this, id = info.id, action] {
      const auto [shown, index] = m_window.results().tab(id);
      action->setEnabled(shown->isTabVisible(index));
    });
    connect(&menu, &QMenu::aboutToHide, action, [action] { action->setEnabled(true); });
  }
}

/// Adds the action to the menu, and a button for it at the end of the tabs.
void WindowActions::addEnlargeAction(QMenu& menu) {
  m_enlarge = addTo(menu, nullptr, tr("&Enlarge Lower Pages"), QKeySequence(tr("Ctrl+0")), this, [] {});
  m_enlarge->setCheckable(true);
  auto* button = new QToolButton;
  button->setAutoRaise(true);
  button->setArrowType(Qt::UpArrow);
  button->setCheckable(true);
  button->setToolTip(tr("Enlarge the lower pages over the picture, or reduce them again (Ctrl+0)"));
  button->setAccessibleName(tr("Enlarge lower pages"));
  m_window.pageTabs().last()->setCornerWidget(button);
  connect(button, &QToolButton::toggled, m_enlarge, &QAction::setChecked);
  connect(m_enlarge, &QAction::toggled, this, [this, button](bool enlarged) {
    m_window.results().setPictureShown(!enlarged);
    button->setChecked(enlarged);
    button->setArrowType(enlarged ? Qt::DownArrow : Qt::UpArrow);
  });
}

void WindowActions::createInstrumentMenu() {
  QMenu& menu = *m_window.menuBar()->addMenu(tr("Instr&ument"));
  InstrumentDesk& desk = m_window.instrumentDesk();
  addTo(menu, nullptr, tr("&Connect…"), QKeySequence(tr("Ctrl+Shift+C")), this,
        [&desk] { desk.showDialog(); });
  QAction* take =
      addTo(menu, nullptr, tr("&Take Reading"), QKeySequence(Qt::Key_F5), this, [&desk] { desk.take(); });
  take->setShortcutContext(Qt::ApplicationShortcut);  // also works in the dialog of the connection
  QAction* leave = addTo(menu, nullptr, tr("&Disconnect"), {}, this, [&desk] { desk.link().close(); });
  const auto offer = [&desk, leave] { leave->setEnabled(desk.link().isOpen()); };
  connect(&desk.link(), &InstrumentLink::stateChanged, leave, offer);
  offer();
}

void WindowActions::createToolsMenu() {
  QMenu& menu = *m_window.menuBar()->addMenu(tr("T&ools"));
  addTo(menu, nullptr, tr("&Blind Trial…"), QKeySequence(tr("Ctrl+B")), this,
        [this] { m_window.sideWindows().showBlindTrials(); });
  addTo(menu, nullptr, tr("&Instrument Check…"), {}, this,
        [this] { m_window.sideWindows().showInstrumentCheck(); });
  addTo(menu, nullptr, tr("Instrument &Records…"), {}, this,
        [this] { m_window.sideWindows().showRecordHistory(); });
  addTo(menu, nullptr, tr("&Series…"), {}, this, [this] { m_window.sideWindows().showSeries(); });
  addTo(menu, nullptr, tr("&Commands…"), QKeySequence(tr("Ctrl+Shift+P")), this, [this] {
    CommandPalette palette(*m_window.menuBar(), &m_window);
    if (QAction* command = palette.ask()) command->trigger();
  });
}

void WindowActions::createHelpMenu(Dialogs& dialogs) {
  QMenu& menu = *m_window.menuBar()->addMenu(tr("&Help"));
  QAction* guide =
      addTo(menu, nullptr, tr("&Guide"), QKeySequence::HelpContents, this, [this] { showHelp(); });
  guide->setShortcutContext(Qt::ApplicationShortcut);  // also works in the window of blind trials
  addTo(menu, nullptr, tr("&First Measurement"), {}, this, [this] { showFirstSteps(); });
  addTo(menu, nullptr, tr("&Keys of the Table"), {}, this, [&dialogs] { dialogs.showShortcuts(); });
  menu.addSeparator();
  addTo(menu, nullptr, tr("&Start Page"), {}, this, [this] {
    m_window.commitPending();
    m_window.showStart();
  });
  addTo(menu, nullptr, tr("&Check This Installation…"), {}, this,
        [this] { m_window.sideWindows().showInstallationCheck(); });
  addTo(menu, nullptr, tr("&About Alidade"), {}, this, [&dialogs] { dialogs.showAbout(); });
}

void WindowActions::showHelp() {
  showGuide(helpTopicOf(QApplication::focusWidget()));
}

void WindowActions::showFirstSteps() {
  showGuide(firstHelpTopic());
}

void WindowActions::showGuide(const QString& topic) {
  if (!m_guide) m_guide = new HelpWindow(&m_window);
  m_guide->showTopic(topic);
}

}  // namespace alidade::ui
