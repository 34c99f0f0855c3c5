#include "ui/help/help_window.h"

#include <QAction>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QShortcut>
#include <QSplitter>
#include <QTextBrowser>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/help/help_topics.h"

namespace alidade::ui {

HelpWindow::HelpWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), m_contents(new QListWidget), m_browser(new QTextBrowser) {
  setWindowTitle(tr("Guide"));
  setObjectName(QStringLiteral("guide"));
  resize(880, 640);
  for (const HelpPage& page : allHelpPages())
    m_contents->addItem(QCoreApplication::translate("HelpPage", page.title));
  m_contents->setAccessibleName(tr("Pages of the guide"));
  connect(m_contents, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0)
      m_browser->setSource(helpUrl(QString::fromLatin1(allHelpPages()[static_cast<std::size_t>(row)].id)));
  });
  connect(m_browser, &QTextBrowser::sourceChanged, this, &HelpWindow::followPage);
  m_browser->setOpenExternalLinks(true);
  auto* parts = new QSplitter;
  parts->addWidget(m_contents);
  parts->addWidget(m_browser);
  parts->setSizes({230, 650});
  parts->setStretchFactor(1, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(createBar());
  layout->addWidget(parts, 1);
  style();
}

QWidget* HelpWindow::createBar() {
  auto* bar = new QWidget;
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const QString& text, const QString& tip, auto call) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setToolTip(tip);
    connect(button, &QToolButton::clicked, this, call);
    layout->addWidget(button);
    return button;
  };
  QToolButton* back = add(tr("← Back"), tr("Back (Alt+Left)"), [this] { m_browser->backward(); });
  QToolButton* forward = add(tr("Forward →"), tr("Forward (Alt+Right)"), [this] { m_browser->forward(); });
  back->setEnabled(false);
  forward->setEnabled(false);
  connect(m_browser, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(m_browser, &QTextBrowser::forwardAvailable, forward, &QWidget::setEnabled);
  layout->addStretch();
  m_notFound = new QLabel;
  layout->addWidget(m_notFound);
  m_search = new QLineEdit;
  m_search->setPlaceholderText(tr("Find in this page (Ctrl+F)"));
  m_search->setClearButtonEnabled(true);
  m_search->setMinimumWidth(220);
  layout->addWidget(m_search);
  connect(m_search, &QLineEdit::returnPressed, this, [this] { find(false); });
  connect(m_search, &QLineEdit::textEdited, this, [this] { m_notFound->clear(); });
  const auto on = [this](const QKeySequence& keys, auto call) {
    connect(new QShortcut(keys, this), &QShortcut::activated, this, call);
  };
  on(QKeySequence::Find, [this] {
    m_search->setFocus();
    m_search->selectAll();
  });
  on(QKeySequence(Qt::Key_F3), [this] { find(false); });
  on(QKeySequence(Qt::SHIFT | Qt::Key_F3), [this] { find(true); });
  on(QKeySequence(Qt::Key_Escape), [this] { close(); });
  return bar;
}

/// Searches from the last match, wrapping at the end.
void HelpWindow::find(bool backward) {
  const QString text = m_search->text();
  if (text.isEmpty()) return;
  const QTextDocument::FindFlags way = backward ? QTextDocument::FindBackward : QTextDocument::FindFlags();
  if (!m_browser->find(text, way)) {
    const QTextCursor before = m_browser->textCursor();
    m_browser->moveCursor(backward ? QTextCursor::End : QTextCursor::Start);
    if (!m_browser->find(text, way)) {
      m_browser->setTextCursor(before);
      m_notFound->setText(tr("Not in this page"));
      return;
    }
  }
  m_notFound->clear();
}

void HelpWindow::showTopic(const QString& topic) {
  m_browser->setSource(helpUrl(topic));
  show();
  raise();
  activateWindow();
  m_browser->setFocus();
}

/// Marks the open page in the contents.
void HelpWindow::followPage(const QUrl& page) {
  const QString file = page.path();
  const std::vector<HelpPage>& pages = allHelpPages();
  const QSignalBlocker quiet(m_contents);
  for (std::size_t i = 0; i < pages.size(); ++i)
    if (file == helpUrl(QString::fromLatin1(pages[i].id)).path())
      m_contents->setCurrentRow(static_cast<int>(i));
}

/// Sets the style of the pages, with colours of the palette only.
void HelpWindow::style() {
  const auto colour = [this](QPalette::ColorRole role) { return palette().color(role).name(); };
  m_browser->document()->setDefaultStyleSheet(
      QStringLiteral("h1 { font-size: x-large; } h2 { font-size: large; margin-top: 14px; }"
                     "a { color: %1; } td, th { padding: 3px 10px 3px 0; } th { text-align: left; }"
                     "code { font-family: 'DejaVu Sans Mono'; } li { margin-bottom: 4px; }")
          .arg(colour(QPalette::Link)));
  if (!m_browser->source().isEmpty()) m_browser->reload();
}

void HelpWindow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) style();
}

}  // namespace alidade::ui
