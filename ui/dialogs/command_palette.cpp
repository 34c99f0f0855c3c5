#include "ui/dialogs/command_palette.h"

#include <QAction>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <algorithm>

namespace alidade::ui {

namespace {

/// Removes the Alt mnemonic, the shortcut after a tab, and an ellipsis at the end.
QString plainText(const QString& menuText) {
  QString plain;
  static const QRegularExpression inBrackets(QStringLiteral("\\(&.\\)"));  // mnemonic of Chinese menus
  const QString text = menuText.section(u'\t', 0, 0).remove(inBrackets);
  for (qsizetype i = 0; i < text.size(); ++i) {
    if (text[i] == u'&' && i + 1 < text.size()) ++i;
    plain += text[i];
  }
  return plain.endsWith(QStringLiteral("…")) ? plain.chopped(1) : plain;
}

/// True if each typed word is the beginning of a word of the path.
bool isMatch(const QString& path, const QString& typed) {
  const QStringList words = typed.split(u' ', Qt::SkipEmptyParts);
  const QString searched = u' ' + path;
  return std::ranges::all_of(
      words, [&](const QString& word) { return searched.contains(u' ' + word, Qt::CaseInsensitive); });
}

}  // namespace

CommandPalette::CommandPalette(const QMenuBar& menus, QWidget* parent)
    : QDialog(parent), m_typed(new QLineEdit), m_list(new QListWidget) {
  setWindowTitle(tr("Commands"));
  m_typed->setPlaceholderText(tr("Type a part of the command's name"));
  m_typed->setAccessibleName(tr("Command"));
  m_typed->installEventFilter(this);
  m_list->setAccessibleName(tr("Commands"));
  m_list->setFocusPolicy(Qt::NoFocus);
  m_list->setAlternatingRowColors(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_typed);
  layout->addWidget(m_list, 1);
  resize(460, 380);
  for (const QAction* menu : menus.actions())
    if (menu->menu()) gather(*menu->menu(), plainText(menu->text()));
  connect(m_typed, &QLineEdit::textChanged, this, &CommandPalette::narrow);
  connect(m_list, &QListWidget::itemClicked, this, &QDialog::accept);
  narrow({});
}

/// Emits `aboutToShow`, since menus update their commands only then.
void CommandPalette::gather(QMenu& menu, const QString& path) {
  emit menu.aboutToShow();
  for (QAction* action : menu.actions()) {
    if (action->isSeparator() || !action->isVisible()) continue;
    const QString own = path + QStringLiteral(" › ") + plainText(action->text());
    if (action->menu()) {
      gather(*action->menu(), own);
    } else if (action->isEnabled()) {
      m_commands.push_back({action, own, action->shortcut().toString(QKeySequence::NativeText)});
    }
  }
  emit menu.aboutToHide();
}

void CommandPalette::narrow(const QString& typed) {
  m_list->clear();
  for (std::size_t i = 0; i < m_commands.size(); ++i) {
    const Command& command = m_commands[i];
    if (!isMatch(command.path, typed)) continue;
    const QString keys = command.keys.isEmpty() ? QString() : QStringLiteral("   (%1)").arg(command.keys);
    auto* item = new QListWidgetItem(command.path + keys, m_list);
    item->setData(Qt::UserRole, static_cast<qulonglong>(i));
  }
  m_list->setCurrentRow(0);
}

QAction* CommandPalette::ask() {
  m_typed->setFocus();
  if (exec() != Accepted || !m_list->currentItem()) return nullptr;
  return m_commands[m_list->currentItem()->data(Qt::UserRole).toULongLong()].action;
}

/// The input line keeps the keyboard focus; Up and Down choose in the list.
bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_typed || event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const int last = m_list->count() - 1, row = m_list->currentRow();
  switch (key) {
    case Qt::Key_Down:
      m_list->setCurrentRow(std::min(row + 1, last));
      return true;
    case Qt::Key_Up:
      m_list->setCurrentRow(std::max(row - 1, 0));
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      accept();
      return true;
    default:
      return false;
  }
}

}  // namespace alidade::ui
