#include "ui/dialogs/recovery_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/dialogs/changed_file.h"
#include "ui/panels/parts/dialog_parts.h"

namespace alidade::ui {

RecoveryDialog::RecoveryDialog(const QList<RecoveryOffer>& offers, QWidget* parent)
    : QDialog(parent), m_names(new QListWidget), m_offers(new QStackedWidget) {
  setWindowTitle(tr("Unsaved changes were kept"));
  resize(720, 420);
  m_names->setObjectName(QStringLiteral("kept sessions"));
  m_names->setMaximumWidth(190);
  for (const RecoveryOffer& offer : offers) addOffer(offer);
  connect(m_names, &QListWidget::currentRowChanged, m_offers, &QStackedWidget::setCurrentIndex);
  m_names->setCurrentRow(0);
  m_names->setVisible(offers.size() > 1);
  auto* parts = new QHBoxLayout;
  parts->addWidget(m_names);
  parts->addWidget(m_offers, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(
      createPlainLabel(tr("Alidade ended without saving. Recover puts the changes back into the window, "
                          "unsaved; the file stays as it is until you save.")));
  layout->addLayout(parts, 1);
  layout->addWidget(createButtons());
}

void RecoveryDialog::addOffer(const RecoveryOffer& offer) {
  m_names->addItem(offer.name);
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(createPlainLabel(offer.name + QStringLiteral(": ") + offer.details));
  layout->addWidget(createPlainLabel(differenceCount(offer.difference) + u':'));
  layout->addWidget(createDifferenceTable(offer.difference, tr("Kept, unsaved"), tr("In the file")), 1);
  m_offers->addWidget(page);
}

QWidget* RecoveryDialog::createButtons() {
  auto* buttons = new QDialogButtonBox;
  const auto offer = [&](const QString& text, QDialogButtonBox::ButtonRole role,
                         RecoveryAnswer::Choice choice) {
    QPushButton* button = buttons->addButton(text, role);
    connect(button, &QPushButton::clicked, this, [this, choice] {
      if (choice == RecoveryAnswer::Choice::Discard && !isDiscardConfirmed()) return;
      m_answer = {choice, m_names->currentRow()};
      accept();
    });
    return button;
  };
  offer(tr("&Recover"), QDialogButtonBox::ActionRole, RecoveryAnswer::Choice::Recover)->setDefault(true);
  offer(tr("&Later"), QDialogButtonBox::ActionRole, RecoveryAnswer::Choice::Later)
      ->setToolTip(tr("Keeps the changes; File, Recover Unsaved Changes… offers them again"));
  offer(tr("&Discard…"), QDialogButtonBox::DestructiveRole, RecoveryAnswer::Choice::Discard)
      ->setAutoDefault(false);
  return buttons;
}

bool RecoveryDialog::isDiscardConfirmed() {
  QMessageBox box(
      QMessageBox::Warning, tr("Discard unsaved changes"),
      tr("Once discarded, the changes of “%1” cannot be recovered.").arg(m_names->currentItem()->text()),
      QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setTextFormat(Qt::PlainText);
  box.setDefaultButton(QMessageBox::Cancel);
  makeSafeButton(*qobject_cast<QPushButton*>(box.button(QMessageBox::Cancel)));
  return box.exec() == QMessageBox::Discard;
}

RecoveryAnswer RecoveryDialog::ask() {
  m_answer = {};
  exec();
  return m_answer;
}

}  // namespace alidade::ui
