#include "ui/dialogs/changed_file.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/dialogs/difference_table.h"
#include "ui/dialogs/safe_button.h"
#include "ui/panels/parts/plain_label.h"

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
    return said + u' ' + ChangedFileText::tr("It is no session now: %1").arg(file.problem);
  return said + u' ' + differenceCount(*file.difference) + u':';
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
    layout->addWidget(createDifferenceTable(*file.difference, ChangedFileText::tr("Here"),
                                            ChangedFileText::tr("In the file")),
                      1);
  layout->addWidget(createPlainLabel(ChangedFileText::tr(
      "Reload takes over what is in the file; undo brings back what is here. Overwrite replaces what "
      "is in the file, and that cannot be undone.")));
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

}  // namespace alidade::ui
