#include "tests/ui/shown_texts.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QGraphicsSimpleTextItem>
#include <QGraphicsView>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QStatusBar>
#include <QTabBar>
#include <QTextDocument>

#include "tests/support/hostile.h"

namespace alidade::ui {

namespace {

class Collector {
 public:
  std::vector<ShownText> texts;

  void addAllOf(QWidget& widget) {
    m_where = QString::fromLatin1(widget.metaObject()->className()) + u' ' + widget.objectName();
    add("title", widget.windowTitle());
    add("tool tip", widget.toolTip());
    add("status tip", widget.statusTip());
    add("help", widget.whatsThis());
    add("spoken name", widget.accessibleName());
    add("spoken description", widget.accessibleDescription());
    addContents(widget);
    for (const QAction* action : widget.actions()) {
      add("action", action->text());
      add("action's tool tip", action->toolTip());
      add("action's status tip", action->statusTip());
    }
  }

 private:
  void add(const char* what, const QString& text) {
    if (!text.isEmpty()) texts.push_back({m_where + QStringLiteral(", ") + QString::fromLatin1(what), text});
  }

  void addContents(QWidget& widget) {
    if (const auto* label = qobject_cast<QLabel*>(&widget)) addLabel(*label);
    if (const auto* button = qobject_cast<QAbstractButton*>(&widget)) add("button", button->text());
    if (const auto* line = qobject_cast<QLineEdit*>(&widget); line && !line->hasFocus()) {
      add("entry", line->text());
      add("placeholder", line->placeholderText());
    }
    if (const auto* notes = qobject_cast<QPlainTextEdit*>(&widget); notes && !notes->hasFocus())
      add("entry", notes->toPlainText());
    if (const auto* group = qobject_cast<QGroupBox*>(&widget)) add("group", group->title());
    if (const auto* progress = qobject_cast<QProgressBar*>(&widget)) add("progress", progress->text());
    if (const auto* bar = qobject_cast<QStatusBar*>(&widget)) add("message", bar->currentMessage());
    if (const auto* tabs = qobject_cast<QTabBar*>(&widget)) addTabs(*tabs);
    if (const auto* choice = qobject_cast<QComboBox*>(&widget)) addModel(*choice->model());
    if (const auto* view = qobject_cast<QAbstractItemView*>(&widget); view && view->model())
      addModel(*view->model());
    if (const auto* view = qobject_cast<QGraphicsView*>(&widget); view && view->scene())
      for (const QGraphicsItem* item : view->scene()->items()) {
        add("figure's tool tip", item->toolTip());
        if (const auto* text = dynamic_cast<const QGraphicsSimpleTextItem*>(item))
          add("figure", text->text());
      }
  }

  void addLabel(const QLabel& label) {
    if (label.textFormat() != Qt::RichText) return add("label", label.text());
    QTextDocument document;
    document.setHtml(label.text());
    add("label", document.toPlainText());
  }

  void addTabs(const QTabBar& tabs) {
    for (int tab = 0; tab < tabs.count(); ++tab) {
      add("tab", tabs.tabText(tab));
      add("tab's tool tip", tabs.tabToolTip(tab));
    }
  }

  void addModel(const QAbstractItemModel& model, const QModelIndex& parent = {}) {
    constexpr int roles[] = {Qt::DisplayRole,        Qt::ToolTipRole,   Qt::StatusTipRole,
                             Qt::AccessibleTextRole, Qt::WhatsThisRole, Qt::AccessibleDescriptionRole};
    for (int column = 0; column < model.columnCount(parent); ++column)
      for (const int role : roles) {
        add("heading", model.headerData(column, Qt::Horizontal, role).toString());
        for (int row = 0; row < model.rowCount(parent); ++row)
          add("cell", model.index(row, column, parent).data(role).toString());
      }
    for (int row = 0; row < model.rowCount(parent); ++row)
      if (const QModelIndex index = model.index(row, 0, parent); model.hasChildren(index))
        addModel(model, index);
  }

  QString m_where;
};

}  // namespace

std::vector<ShownText> shownTexts(QWidget& window) {
  Collector collector;
  collector.addAllOf(window);
  for (QWidget* widget : window.findChildren<QWidget*>()) collector.addAllOf(*widget);
  return std::move(collector.texts);
}

void expectAllVisible(QWidget& window, const QString& when) {
  for (const ShownText& shown : shownTexts(window))
    EXPECT_FALSE(test::firstForbidden(shown.text.toStdString(), "\n\t"))
        << when.toStdString() << ": " << shown.where.toStdString() << ": "
        << testing::PrintToString(shown.text.toStdString());
  for (QLabel* label : window.findChildren<QLabel*>()) {
    label->ensurePolished();
    EXPECT_NE(label->textFormat(), Qt::AutoText) << when.toStdString() << ": " << label->text().toStdString();
  }
}

}  // namespace alidade::ui
