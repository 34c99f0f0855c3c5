#include "ui/dialogs/changed_file.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/panels/parts/dialog_parts.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

struct ChangedFileText {
  Q_DECLARE_TR_FUNCTIONS(ChangedFileText)
};

QString explanation(const ChangedFile& file) {
  const QString said = ChangedFileText::tr(
                           "“%1” was written by another program or window since it was last read or "
                           "saved here.")
                           .arg(file.name);
  if (!file.difference)
    return said + u' ' + ChangedFileText::tr("The file is no longer a session: %1").arg(file.problem);
  return said + u' ' + differenceCount(*file.difference) + u':';
}

struct DifferenceText {
  Q_DECLARE_TR_FUNCTIONS(DifferenceText)
};

QString orNothing(const QString& text) {
  return text.isEmpty() ? QStringLiteral("—") : visibleLine(text);
}

}  // namespace

ChangedFileAnswer askChangedFile(QWidget* parent, const ChangedFile& file) {
  QDialog dialog(parent);
  dialog.setObjectName(QStringLiteral("changed file"));
  dialog.setWindowTitle(ChangedFileText::tr("The file was changed"));
  dialog.resize(620, 380);
  auto* layout = new QVBoxLayout(&dialog);
  layout->addWidget(createPlainLabel(explanation(file)));
  if (file.difference)
    layout->addWidget(createDifferenceTable(*file.difference, ChangedFileText::tr("In this window"),
                                            ChangedFileText::tr("In the file")),
                      1);
  layout->addWidget(createPlainLabel(
      ChangedFileText::tr("Reload uses the file's content; undo restores the content of this window. "
                          "Overwrite replaces the file's content and cannot be undone.")));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  ChangedFileAnswer answer = ChangedFileAnswer::Cancel;
  const auto offer = [&](const QString& text, QDialogButtonBox::ButtonRole role, ChangedFileAnswer given) {
    QPushButton* button = buttons->addButton(text, role);
    QObject::connect(button, &QPushButton::clicked, &dialog, [&dialog, &answer, given] {
      answer = given;
      dialog.accept();
    });
    return button;
  };
  offer(ChangedFileText::tr("&Reload"), QDialogButtonBox::ActionRole, ChangedFileAnswer::Reload)
      ->setEnabled(file.difference.has_value());
  offer(ChangedFileText::tr("Save &As…"), QDialogButtonBox::ActionRole, ChangedFileAnswer::SaveAs);
  offer(ChangedFileText::tr("&Overwrite"), QDialogButtonBox::DestructiveRole, ChangedFileAnswer::Overwrite);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  layout->addWidget(buttons);
  makeSafeButton(*buttons->button(QDialogButtonBox::Cancel));
  dialog.exec();
  return answer;
}

QTreeWidget* createDifferenceTable(const SessionDifference& difference, const QString& mine,
                                   const QString& theirs) {
  auto* table = new QTreeWidget;
  table->setHeaderLabels({DifferenceText::tr("Entry"), mine, theirs});
  table->setRootIsDecorated(false);
  table->setUniformRowHeights(true);
  table->setAlternatingRowColors(true);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  QList<QTreeWidgetItem*> rows;
  for (const EntryDifference& entry : difference.entries)
    rows.append(
        new QTreeWidgetItem({visibleLine(entry.where), orNothing(entry.mine), orNothing(entry.theirs)}));
  const std::size_t more = difference.count - difference.entries.size();
  if (more > 0) rows.append(new QTreeWidgetItem({DifferenceText::tr("and %1 more").arg(more)}));
  table->addTopLevelItems(rows);
  constexpr int margin = 14, widest = 260;
  for (int column = 0; column < table->columnCount(); ++column) {
    table->resizeColumnToContents(column);
    table->setColumnWidth(column, std::min(table->columnWidth(column) + margin, widest));
  }
  table->header()->setStretchLastSection(true);
  return table;
}

}  // namespace alidade::ui
