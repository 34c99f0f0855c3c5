#include "ui/dialogs/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFontInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include "core/session/protocol_progress.h"
#include "core/wording/guidance.h"
#include "ui/commands/change_session.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/logo_form.h"
#include "ui/dialogs/paper_form.h"
#include "ui/dialogs/protocol_flow.h"
#include "ui/document/session_template.h"
#include "ui/forms/field_binding.h"
#include "ui/forms/field_form.h"
#include "ui/language/languages.h"
#include "ui/panels/parts/dialog_parts.h"
#include "ui/panels/parts/protocol_menu.h"
#include "ui/report/report_choice.h"
#include "ui/settings/entry_tone.h"
#include "ui/settings/theme.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr std::string_view fieldsOfNewSessions[] = {"report.laboratory",
                                                    "report.customer",
                                                    "operator",
                                                    "report.authorised_by",
                                                    "instrument.name",
                                                    "instrument.serial",
                                                    "instrument.sigma_horizontal_arcsec",
                                                    "instrument.sigma_vertical_arcsec",
                                                    "instrument.sigma_zero_arcsec",
                                                    "instrument.sigma_slider_arcsec"};

QPushButton* button(const QString& text, const char* name) {
  auto* button = new QPushButton(text);
  button->setAutoDefault(false);
  button->setObjectName(QString::fromLatin1(name));
  return button;
}

/// A row of a text, which takes all the free width, and its buttons.
QWidget* rowOf(QLabel* text, std::initializer_list<QWidget*> buttons) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(text, 1);
  for (QWidget* button : buttons) layout->addWidget(button);
  return row;
}

QLabel* hint(const QString& text) {
  QLabel* label = createPlainLabel(text);
  label->setForegroundRole(QPalette::PlaceholderText);
  return label;
}

}  // namespace

PreferencesDialog::PreferencesDialog(Dialogs& dialogs, QWidget* parent)
    : QDialog(parent), m_dialogs(dialogs), m_pages(new QTabWidget) {
  setWindowTitle(tr("Preferences"));
  m_pages->addTab(createWindowPage(), tr("&Window"));
  m_pages->addTab(createSessionPage(), tr("New &Sessions"));
  m_pages->addTab(createReportPage(), tr("&Report"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &PreferencesDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_pages, 1);
  layout->addWidget(buttons);
  resize(std::max(byFont(520), minimumSizeHint().width()), sizeHint().height());
}

QWidget* PreferencesDialog::createWindowPage() {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  m_language = createLanguageChoice(tr("As the desktop"), rememberedLanguage());
  form->addRow(tr("&Language"), m_language);
  form->addRow({}, hint(tr("Another language applies when Alidade is started again.")));
  form->addRow(tr("Font"), createFontRow());
  m_theme = new QComboBox;
  m_theme->setObjectName(QStringLiteral("colours"));
  const std::pair<QString, Theme> themes[] = {
      {tr("As the desktop"), Theme::System}, {tr("Light"), Theme::Light}, {tr("Dark"), Theme::Dark}};
  for (const auto& [text, theme] : themes) m_theme->addItem(text, static_cast<int>(theme));
  m_theme->setCurrentIndex(m_theme->findData(static_cast<int>(rememberedTheme())));
  form->addRow(tr("&Colours"), m_theme);
  m_tone = new QCheckBox(tr("&Tone for unexpected readings"));
  m_tone->setObjectName(QStringLiteral("tone"));
  m_tone->setChecked(hasTone());
  form->addRow({}, m_tone);
  return page;
}

QWidget* PreferencesDialog::createFontRow() {
  m_fontName = createPlainLabel({});
  m_fontName->setObjectName(QStringLiteral("font name"));
  auto* choose = button(tr("C&hoose…"), "choose font");
  auto* desktop = button(tr("As the &Desktop"), "desktop font");
  m_desktopFont = desktop;
  connect(choose, &QPushButton::clicked, this, [this] {
    if (const auto font = m_dialogs.askFont(fontOf(m_font))) chooseFont({font->family(), font->pointSizeF()});
  });
  connect(desktop, &QPushButton::clicked, this, [this] { chooseFont({}); });
  chooseFont(rememberedFont());
  return rowOf(m_fontName, {choose, desktop});
}

void PreferencesDialog::chooseFont(const FontChoice& choice) {
  m_font = choice;
  m_desktopFont->setEnabled(choice != FontChoice());
  const QFontInfo font(fontOf(choice));
  m_fontName->setText(tr("%1, %2 pt").arg(font.family(), plainNumberText(font.pointSizeF())));
}

QWidget* PreferencesDialog::createSessionPage() {
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->addWidget(hint(tr("New sessions start with these entries. Open sessions keep theirs.")));
  layout->addWidget(new FieldForm(m_template, fieldsOfNewSessions, 2));
  layout->addWidget(createProtocolRow());
  layout->addStretch();
  return page;
}

QWidget* PreferencesDialog::createProtocolRow() {
  m_protocolName = createPlainLabel({});
  m_protocolName->setObjectName(QStringLiteral("protocol name"));
  auto* choose = button(tr("C&hoose"), "choose protocol");
  auto* menu = new QMenu(choose);
  addNamedProtocols(*menu,
                    [this](const SightingProtocol& protocol) { followProtocol(m_template, protocol); });
  choose->setMenu(menu);
  auto* load = button(tr("&Load…"), "load protocol");
  auto* none = button(tr("&None"), "no protocol");
  m_noProtocol = none;
  auto* flow = new ProtocolFlow(m_template, m_dialogs, this);
  connect(load, &QPushButton::clicked, flow, &ProtocolFlow::load);
  connect(none, &QPushButton::clicked, this, [this] { followProtocol(m_template, {}); });
  connect(&m_template, &SessionDocument::changed, this, &PreferencesDialog::showProtocol);
  showProtocol();
  return rowOf(m_protocolName, {choose, load, none});
}

void PreferencesDialog::showProtocol() {
  const auto protocol = protocolOf(m_template.session());
  const bool isThere = protocol && *protocol;
  m_noProtocol->setEnabled(isThere);
  m_protocolName->setText(isThere ? tr("Protocol: %1, %2 sightings")
                                        .arg(qText(protocolInWords(**protocol)))
                                        .arg(sightingCount(**protocol))
                                  : tr("Protocol: none"));
}

QWidget* PreferencesDialog::createReportPage() {
  const ReportChoice choice = rememberedReportChoice();
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  m_paper = new PaperForm(choice.paper);
  m_reportLanguage = createLanguageChoice(tr("Like the window"), choice.language);
  m_reportLanguage->setObjectName(QStringLiteral("report language"));
  m_paper->addRow(new QLabel(tr("L&anguage")), m_reportLanguage);
  m_logo = new LogoForm(choice.logoPath);
  layout->addWidget(m_paper);
  layout->addWidget(
      hint(tr("The report is printed in portrait format; wide margins make the print smaller.")));
  layout->addWidget(m_logo);
  layout->addStretch();
  return page;
}

/// False if an entry is unusable; then shows the first unusable entry.
bool PreferencesDialog::isUsable() {
  for (FieldBinding* binding : findChildren<FieldBinding*>()) {
    emit binding->commitWanted();
    if (binding->problem().isEmpty()) continue;
    m_pages->setCurrentIndex(1);
    binding->widget()->setFocus(Qt::TabFocusReason);
    return false;
  }
  return true;
}

void PreferencesDialog::accept() {
  if (!isUsable()) return;
  keepTemplate(m_template.session());
  rememberLanguage(m_language->currentData().toString());
  if (m_font != rememberedFont()) applyFont(m_font);
  const auto theme = static_cast<Theme>(m_theme->currentData().toInt());
  if (theme != rememberedTheme()) applyTheme(theme);
  setTone(m_tone->isChecked());
  ReportChoice choice = rememberedReportChoice();
  choice.paper = m_paper->paper();
  choice.language = m_reportLanguage->currentData().toString();
  choice.logoPath = m_logo->path();
  rememberReportChoice(choice);
  QDialog::accept();
}

}  // namespace alidade::ui
