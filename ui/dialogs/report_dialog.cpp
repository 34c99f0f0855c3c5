#include "ui/dialogs/report_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/dialogs/logo_form.h"
#include "ui/dialogs/paper_form.h"
#include "ui/panels/parts/dialog_parts.h"
#include "ui/recovery/form_draft.h"
#include "ui/settings/theme.h"
#include "ui/settings/window_font.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

bool holds(const std::vector<ReportPart>& parts, ReportPart part) {
  return std::ranges::find(parts, part) != parts.end();
}

QWidget* warning(const QString& text) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* icon = new QLabel;
  icon->setPixmap(themeIcon(QStringLiteral("warning")).pixmap(16, 16));
  layout->addWidget(icon, 0, Qt::AlignTop);
  layout->addWidget(createPlainLabel(text), 1);
  return row;
}

}  // namespace

ReportDialog::ReportDialog(const ReportQuestion& question, QWidget* parent)
    : QDialog(parent), m_question(question) {
  setWindowTitle(question.isCertificate ? tr("Calibration certificate") : tr("Acceptance report"));
  auto* columns = new QHBoxLayout;
  columns->addWidget(createContents(), 1);
  columns->addWidget(createSheet(), 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(createLacks());
  if (m_question.isCertificate) layout->addWidget(createCertificate());
  layout->addLayout(columns, 1);
  layout->addWidget(createButtons());
  keepDraft();
  // Opens the dialog high enough for all sentences, wrapped at the dialog's width.
  layout->activate();
  const int width = std::max(byFont(640), minimumSizeHint().width());
  resize(width, std::max(sizeHint().height(), layout->totalHeightForWidth(width)));
}

void ReportDialog::keepDraft() {
  auto* draft = new FormDraft(QStringLiteral("report"), {}, this);
  for (const ReportPartInfo& info : allReportParts())
    if (const auto box = m_parts.find(info.part); box != m_parts.end() && box->second->isEnabled())
      draft->add(box->second->objectName(), *box->second);
  draft->add(m_session->objectName(), *m_session);
  m_paper->keepIn(*draft);
  draft->finishWith(*this);
}

/// Lists what the report will lack, above the choices.
QWidget* ReportDialog::createLacks() {
  auto* lacks = new QWidget;
  auto* layout = new QVBoxLayout(lacks);
  layout->setContentsMargins(0, 0, 0, 0);
  if (const int count = m_question.unusable; count > 0)
    layout->addWidget(warning(
        count == 1
            ? tr("1 entry cannot be used. The report will list it and give no verdict.")
            : tr("%1 entries cannot be used. The report will list them and give no verdict.").arg(count)));
  if (!m_question.emptyFields.isEmpty()) {
    const QString fields = listText(m_question.emptyFields);
    layout->addWidget(
        warning((m_question.isCertificate
                     ? tr("ISO/IEC 17025 requires entries that the session lacks: %1. Fill them in on the "
                          "forms of the window; without them only a draft can be made.")
                     : tr("The session lacks entries that a laboratory's report should state: %1. The report "
                          "marks them “not stated”; fill them in on the forms of the window."))
                    .arg(fields)));
  }
  return lacks;
}

QWidget* ReportDialog::createCertificate() {
  auto* group = new QGroupBox(tr("What the certificate states"));
  auto* form = new QFormLayout(group);
  const CertificateEntries& last = m_question.choice.certificate;
  m_country = new QLineEdit(last.country);
  m_country->setMaxLength(2);
  m_country->setPlaceholderText(QStringLiteral("DE"));
  m_country->setToolTip(tr("Country of the laboratory: its two-letter code in ISO 3166-1"));
  m_performedAt = new QComboBox;
  m_performedAt->addItem(tr("not stated"), QString());
  m_performedAt->addItem(tr("at the laboratory"), QStringLiteral("laboratory"));
  m_performedAt->addItem(tr("at the customer"), QStringLiteral("customer"));
  m_performedAt->addItem(tr("at a branch of the laboratory"), QStringLiteral("laboratoryBranch"));
  m_performedAt->addItem(tr("at a branch of the customer"), QStringLiteral("customerBranch"));
  m_performedAt->addItem(tr("elsewhere"), QStringLiteral("other"));
  m_performedAt->setCurrentIndex(std::max(0, m_performedAt->findData(last.performedAt)));
  m_maker = new QLineEdit(last.manufacturer);
  m_draft = new QCheckBox(tr("&Draft: say “not stated” for what is missing"));
  form->addRow(tr("&Country"), m_country);
  form->addRow(tr("&Measured"), m_performedAt);
  form->addRow(tr("Ma&ker of the device"), m_maker);
  form->addRow(m_draft);
  return group;
}

QWidget* ReportDialog::createContents() {
  auto* group = new QGroupBox(tr("Contents of the report"));
  auto* layout = new QVBoxLayout(group);
  layout->addWidget(createPlainLabel(
      tr("Always: result, U and verdict, findings, terms, excluded and changed readings, notes.")));
  for (const ReportPartInfo& info : allReportParts()) {
    if (!holds(m_question.there, info.part)) continue;
    auto* box = new QCheckBox(QCoreApplication::translate("ReportPart", info.title));
    box->setObjectName(QString::fromLatin1(info.id));
    const bool must = holds(m_question.mandatory, info.part);
    box->setChecked(must || !m_question.choice.contents.leftOut.contains(info.part));
    box->setEnabled(!must);
    if (must) box->setText(tr("%1 (model and readings disagree)").arg(box->text()));
    layout->addWidget(box);
    m_parts[info.part] = box;
  }
  m_session = new QCheckBox(tr("Session file and results, &attached to the PDF"));
  m_session->setObjectName(QStringLiteral("session"));
  m_session->setToolTip(
      tr("Alidade can open the session from the PDF again. The PDF then contains all readings."));
  m_session->setChecked(m_question.choice.hasSession);
  m_session->setVisible(m_question.way == ReportQuestion::Way::Export);
  layout->addSpacing(6);
  layout->addWidget(m_session);
  layout->addStretch();
  return group;
}

QWidget* ReportDialog::createSheet() {
  auto* side = new QWidget;
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* page = new QGroupBox(tr("Page"));
  m_paper = new PaperForm(m_question.choice.paper);
  auto* pageLayout = new QVBoxLayout(page);
  pageLayout->addWidget(m_paper);
  m_language = createLanguageChoice(tr("Like the window"), m_question.choice.language);
  m_paper->addRow(new QLabel(tr("&Language")), m_language);
  layout->addWidget(page);
  m_logo = new LogoForm(m_question.choice.logoPath);
  layout->addWidget(m_logo);
  layout->addWidget(createHistory());
  layout->addStretch();
  return side;
}

QWidget* ReportDialog::createHistory() {
  auto* group = new QGroupBox(tr("History of the device"));
  m_seriesName = createPlainLabel({});
  auto* choose = new QPushButton(tr("Choose &folder…"));
  choose->setAutoDefault(false);
  choose->setToolTip(
      tr("Folder of the sessions of this device: the report shows Δd over time on a separate page"));
  auto* none = new QPushButton(tr("W&ithout"));
  none->setAutoDefault(false);
  none->setObjectName(QStringLiteral("no history"));
  m_noSeries = none;
  connect(choose, &QPushButton::clicked, this, [this] {
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Sessions of this device"), m_seriesFolder);
    if (!folder.isEmpty()) setSeriesFolder(folder);
  });
  connect(none, &QPushButton::clicked, this, [this] { setSeriesFolder({}); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(choose);
  buttons->addWidget(none);
  buttons->addStretch();
  auto* layout = new QVBoxLayout(group);
  layout->addWidget(m_seriesName);
  layout->addLayout(buttons);
  setSeriesFolder(m_question.choice.seriesFolder);
  return group;
}

void ReportDialog::setSeriesFolder(const QString& folder) {
  m_seriesFolder = folder;
  m_noSeries->setEnabled(!folder.isEmpty());
  m_seriesName->setText(folder.isEmpty() ? tr("Left out") : shortLine(QFileInfo(folder).fileName(), 40));
  m_seriesName->setToolTip(tipText(folder));
}

QWidget* ReportDialog::createButtons() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel,
                                       this);  // `setDefault` requires a dialog as parent
  const QString texts[] = {tr("&Export…"), tr("P&rint…"), tr("&Show")};
  QPushButton* go = buttons->addButton(texts[static_cast<int>(m_question.way)], QDialogButtonBox::AcceptRole);
  QPushButton* cancel = buttons->button(QDialogButtonBox::Cancel);
  (m_question.unusable > 0 ? cancel : go)->setDefault(true);
  (m_question.unusable > 0 ? cancel : go)->setFocus();
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  return buttons;
}

ReportChoice ReportDialog::choice() const {
  ReportChoice choice = m_question.choice;
  for (const auto& [part, box] : m_parts) {
    if (!box->isEnabled()) continue;
    box->isChecked() ? (void)choice.contents.leftOut.erase(part) : (void)choice.contents.leftOut.insert(part);
  }
  choice.paper = m_paper->paper();
  choice.logoPath = m_logo->path();
  choice.seriesFolder = m_seriesFolder;
  choice.language = m_language->currentData().toString();
  choice.hasSession = m_session->isChecked();
  if (m_question.isCertificate)
    choice.certificate = {.measuredOn = {},
                          .country = m_country->text().trimmed().toUpper(),
                          .performedAt = m_performedAt->currentData().toString(),
                          .manufacturer = m_maker->text().trimmed(),
                          .isDraft = m_draft->isChecked()};
  return choice;
}

}  // namespace alidade::ui
