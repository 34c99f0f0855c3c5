#include "ui/dialogs/paper_form.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/recovery/form_draft.h"

namespace alidade::ui {

PaperForm::PaperForm(const ReportPaper& paper, QWidget* parent) : QWidget(parent), m_size(new QComboBox) {
  m_size->setObjectName(QStringLiteral("paper"));
  m_size->addItem(tr("A4 (210 × 297 mm)"), QPageSize::A4);
  m_size->addItem(tr("Letter (216 × 279 mm)"), QPageSize::Letter);
  m_size->setCurrentIndex(m_size->findData(paper.size));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  auto* sizeLabel = new QLabel(tr("&Paper"));
  sizeLabel->setBuddy(m_size);
  grid->addWidget(sizeLabel, 0, 0);
  grid->addWidget(m_size, 0, 1, 1, 3);
  const std::pair<QString, double> sides[] = {{tr("Le&ft margin"), paper.margins.left()},
                                              {tr("T&op"), paper.margins.top()},
                                              {tr("R&ight"), paper.margins.right()},
                                              {tr("Botto&m"), paper.margins.bottom()}};
  for (int i = 0; i < 4; ++i) {
    auto* entry = new QDoubleSpinBox;
    entry->setRange(ReportPaper::leastMargin, ReportPaper::mostMargin);
    entry->setDecimals(0);
    entry->setSuffix(tr(" mm"));
    entry->setValue(sides[i].second);
    auto* label = new QLabel(sides[i].first);
    label->setBuddy(entry);
    grid->addWidget(label, 1 + i / 2, 2 * (i % 2));
    grid->addWidget(entry, 1 + i / 2, 2 * (i % 2) + 1);
    m_margins[static_cast<std::size_t>(i)] = entry;
  }
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
}

void PaperForm::addRow(QLabel* label, QWidget* entry) {
  auto* grid = static_cast<QGridLayout*>(layout());
  const int row = grid->rowCount();
  label->setBuddy(entry);
  grid->addWidget(label, row, 0);
  grid->addWidget(entry, row, 1, 1, 3);
}

void PaperForm::keepIn(FormDraft& draft) {
  draft.add(m_size->objectName(), *m_size);
  for (std::size_t i = 0; i < m_margins.size(); ++i)
    draft.add(QStringLiteral("margin %1").arg(i), *m_margins[i]);
}

ReportPaper PaperForm::paper() const {
  return {
      static_cast<QPageSize::PageSizeId>(m_size->currentData().toInt()),
      QMarginsF(m_margins[0]->value(), m_margins[1]->value(), m_margins[2]->value(), m_margins[3]->value())};
}

bool askPaper(QWidget* parent, ReportPaper& paper) {
  QDialog dialog(parent);
  dialog.setWindowTitle(PaperForm::tr("Page setup of the report"));
  auto* form = new PaperForm(paper);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* layout = new QVBoxLayout(&dialog);
  layout->addWidget(form);
  auto* hint = new QLabel(
      PaperForm::tr("The report is printed in portrait format; wide margins make the print smaller."));
  layout->addWidget(hint);
  layout->addWidget(buttons);
  if (dialog.exec() != QDialog::Accepted) return false;
  paper = form->paper();
  return true;
}

}  // namespace alidade::ui
