#include "ui/start/start_page.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/settings/recent_files.h"
#include "ui/settings/theme.h"
#include "ui/settings/window_font.h"
#include "ui/start/samples.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int nameWidth = 210;  // pixels

QTreeWidget* createList(const QString& name, const QStringList& titles) {
  auto* list = new QTreeWidget;
  list->setAccessibleName(name);
  list->setHeaderLabels(titles);
  list->setRootIsDecorated(false);
  list->setUniformRowHeights(true);
  list->setAllColumnsShowFocus(true);
  list->setTextElideMode(Qt::ElideMiddle);
  list->header()->setSectionsMovable(false);
  list->header()->resizeSection(0, nameWidth);
  return list;
}

QLabel* createTitle(const QString& text, double size) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setBold(size == 1);
  label->setFont(font);
  scaleFont(*label, size);
  return label;
}

bool isTyped(const QKeyEvent& key) {
  const Qt::KeyboardModifiers held = key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
  return held == Qt::NoModifier && !key.text().isEmpty() && key.text().front().isPrint() &&
         key.key() != Qt::Key_Space;
}

QString dataOf(const QTreeWidgetItem* item) {
  return item->data(0, Qt::UserRole).toString();
}

}  // namespace

StartPage::StartPage(QWidget* parent)
    : QWidget(parent),
      m_recent(createList(tr("Recent files"), {tr("Name"), tr("Folder"), tr("Changed")})),
      m_samples(createList(tr("Samples"), {tr("Sample"), tr("What it shows")})) {
  setObjectName(QStringLiteral("start"));
  m_recent->setObjectName(QStringLiteral("recent files"));
  m_samples->setObjectName(QStringLiteral("samples"));
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(24, 20, 24, 20);
  columns->setSpacing(28);
  columns->addWidget(createActions());
  columns->addWidget(createLists(), 1);
  for (QTreeWidget* list : {m_recent, m_samples}) list->installEventFilter(this);
  connect(m_samples, &QTreeWidget::itemActivated, this,
          [this](const QTreeWidgetItem* item) { emit sampleWanted(dataOf(item)); });
  connect(m_recent, &QTreeWidget::itemActivated, this,
          [this](const QTreeWidgetItem* item) { emit fileWanted(dataOf(item)); });
  fillSamples();
  refresh();
}

QWidget* StartPage::createActions() {
  auto* side = new QWidget;
  layOutByFont(*side, [side] { side->setFixedWidth(byFont(230)); });
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* icon = new QLabel;
  icon->setPixmap(themeIcon(QStringLiteral("alidade")).pixmap(56, 56));
  layout->addWidget(icon);
  layout->addWidget(createTitle(tr("Alidade"), 1.9));
  auto* what =
      new QLabel(tr("Does the centre of a rotatable arc lie on its axis? Enter the readings of a theodolite; "
                    "get the intersection with its uncertainty and a verdict."));
  what->setWordWrap(true);
  layout->addWidget(what);
  layout->addSpacing(12);
  const auto add = [&](const char* sign, const QString& text, void (StartPage::*wanted)()) {
    auto* button = new QPushButton(themeIcon(QString::fromLatin1(sign)), text);
    button->setStyleSheet(QStringLiteral("text-align: left; padding: 6px 10px;"));
    button->setAutoDefault(true);
    connect(button, &QPushButton::clicked, this, wanted);
    layout->addWidget(button);
    return button;
  };
  m_new = add("new", tr("New session"), &StartPage::newWanted);
  add("open", tr("Open a session or report…"), &StartPage::openWanted);
  add("insert", tr("Import readings…"), &StartPage::importWanted);
  add("note", tr("Guide: ten steps"), &StartPage::guideWanted);
  layout->addStretch();
  auto* hint =
      new QLabel(tr("Typing enters text in the session; Esc returns to the session; F1 opens the guide."));
  hint->setForegroundRole(QPalette::PlaceholderText);
  hint->setWordWrap(true);
  layout->addWidget(hint);
  return side;
}

QWidget* StartPage::createLists() {
  auto* side = new QWidget;
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(createTitle(tr("Recent files"), 1));
  layout->addWidget(m_recent, 4);
  layout->addSpacing(8);
  layout->addWidget(createTitle(tr("Samples"), 1));
  layout->addWidget(m_samples, 5);
  m_recent->header()->setStretchLastSection(false);
  m_recent->header()->setSectionResizeMode(1, QHeaderView::Stretch);
  m_recent->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  return side;
}

void StartPage::fillSamples() {
  for (const Sample& sample : allSamples()) {
    auto* item = new QTreeWidgetItem(m_samples);
    item->setText(0, QCoreApplication::translate("Sample", sample.title));
    item->setText(1, QCoreApplication::translate("Sample", sample.shows));
    item->setToolTip(1, item->text(1));
    item->setData(0, Qt::UserRole, QString::fromLatin1(sample.name));
  }
  m_samples->setCurrentItem(m_samples->topLevelItem(0));
}

/// Missing files stay in the list, since the drive may be plugged in again.
void StartPage::refresh() {
  m_recent->clear();
  for (const QString& path : RecentFiles::all()) {
    const QFileInfo file(path);
    const bool isThere = file.isFile();
    const QString changed =
        isThere ? file.lastModified().toString(QStringLiteral("yyyy-MM-dd HH:mm")) : tr("not found");
    auto* item = new QTreeWidgetItem(
        m_recent,
        {visibleLine(file.fileName()), visibleLine(QDir::toNativeSeparators(file.absolutePath())), changed});
    item->setToolTip(0, tipText(QDir::toNativeSeparators(path)));
    item->setData(0, Qt::UserRole, path);
    item->setDisabled(!isThere);
    if (isThere && !m_recent->currentItem()) m_recent->setCurrentItem(item);
  }
  if (m_recent->topLevelItemCount() == 0)
    (new QTreeWidgetItem(m_recent, {tr("No files yet")}))->setDisabled(true);
}

void StartPage::focusFirst() {
  m_recent->currentItem() ? m_recent->setFocus() : m_new->setFocus();
}

/// Forwards typed text to the session; otherwise a list on this page would search for the text.
bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && isTyped(static_cast<const QKeyEvent&>(*event))) {
    emit sessionWanted(static_cast<const QKeyEvent&>(*event).text());
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void StartPage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape)
    emit sessionWanted({});
  else if (isTyped(*event))
    emit sessionWanted(event->text());
  else
    QWidget::keyPressEvent(event);
}

}  // namespace alidade::ui
