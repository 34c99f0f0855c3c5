#include "ui/dialogs/dialogs.h"

#include <QApplication>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFontDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

#include "ui/dialogs/own_effect_dialog.h"
#include "ui/dialogs/paper_form.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/dialogs/protocol_dialog.h"
#include "ui/import/import_page.h"
#include "ui/panels/parts/dialog_parts.h"
#include "ui/settings/theme.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

struct DialogsText {
  Q_DECLARE_TR_FUNCTIONS(DialogsText)
};

constexpr int longestName = 60;

QString sessionFilter() {
  return DialogsText::tr("Sessions and series (*.alidade *.alidade-series);;All files (*)");
}

/// Breaks long words, since a message box is as wide as its longest word.
QString boxText(const QString& text) {
  static const QRegularExpression longWord(QStringLiteral("(\\S{60})(?=\\S)"));
  return visibleLines(text).replace(longWord, QStringLiteral("\\1\n"));
}

QString withSuffix(const QString& path, const QString& suffix) {
  return path.isEmpty() || path.endsWith(suffix) ? path : path + suffix;
}

/// Asks for a file to write; the suffix is added before the question about overwriting.
QString saveFile(QWidget* parent, const QString& title, const QString& suggestion, const QString& filter,
                 const QString& suffix) {
  QFileDialog dialog(parent, title, suggestion, filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  dialog.selectFile(withSuffix(suggestion, QLatin1Char('.') + suffix));
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString lossText(const Dialogs::Unsaved& unsaved) {
  const QString name = shortLine(unsaved.name, longestName);
  QStringList sentences;
  if (unsaved.isModified) sentences.append(DialogsText::tr("“%1” has unsaved changes.").arg(name));
  if (unsaved.waiting > 0)
    sentences.append(DialogsText::tr("Readings of the instrument that are not in “%1” yet: %2.")
                         .arg(name, QString::number(unsaved.waiting)));
  return sentences.join(u' ');
}

QString lossRemedy(const Dialogs::Unsaved& unsaved) {
  QStringList sentences;
  if (unsaved.waiting > 0)
    sentences.append(DialogsText::tr(
        "Cancel to take them in first: a doubtful reading has a question above the table of readings."));
  sentences.append(unsaved.isModified ? DialogsText::tr("Discarded changes cannot be brought back.")
                                      : DialogsText::tr("Discarded readings cannot be brought back."));
  return sentences.join(u' ');
}

}  // namespace

Dialogs::SaveAnswer Dialogs::askLeave(const Unsaved& unsaved) {
  QMessageBox box(QMessageBox::Warning, DialogsText::tr("Unsaved changes"), lossText(unsaved),
                  QMessageBox::Discard | QMessageBox::Cancel, m_parent);
  if (unsaved.isModified) box.addButton(QMessageBox::Save)->setText(DialogsText::tr("&Save"));
  box.setInformativeText(lossRemedy(unsaved));
  box.button(QMessageBox::Discard)->setText(DialogsText::tr("&Discard"));
  box.button(QMessageBox::Cancel)->setText(DialogsText::tr("&Cancel"));
  const auto safe = unsaved.isModified ? QMessageBox::Save : QMessageBox::Cancel;
  box.setDefaultButton(safe);
  makeSafeButton(*qobject_cast<QPushButton*>(box.button(safe)));
  switch (box.exec()) {
    case QMessageBox::Save:
      return SaveAnswer::Save;
    case QMessageBox::Discard:
      return SaveAnswer::Discard;
    default:
      return SaveAnswer::Cancel;
  }
}

bool Dialogs::askDiscardOther(const QString& name, Way way) {
  const QString unnamed = way == Way::Redo
                              ? DialogsText::tr("An import that was undone has not been saved.")
                              : DialogsText::tr("The session before the import has not been saved.");
  QMessageBox box(QMessageBox::Warning, DialogsText::tr("Unsaved changes"),
                  name.isEmpty()
                      ? unnamed
                      : DialogsText::tr("“%1” has unsaved changes, too.").arg(shortLine(name, longestName)),
                  QMessageBox::Discard | QMessageBox::Cancel, m_parent);
  const QString lead =
      way == Way::Redo
          ? DialogsText::tr("Redo restores this session with everything typed, so that you can save it.")
          : DialogsText::tr("Undo restores this session with everything typed, so that you can save it.");
  box.setInformativeText(lead + u' ' + DialogsText::tr("If discarded, it cannot be brought back."));
  box.setDefaultButton(QMessageBox::Cancel);
  makeSafeButton(*qobject_cast<QPushButton*>(box.button(QMessageBox::Cancel)));
  return box.exec() == QMessageBox::Discard;
}

bool Dialogs::askDeletePosition(const QString& name, std::size_t sightings) {
  const QString title = DialogsText::tr("Delete position");
  QMessageBox box(QMessageBox::Question, title,
                  //: %1: "0°", "180° again"
                  DialogsText::tr("Delete the position %1?").arg(shortLine(name, longestName)),
                  QMessageBox::Cancel, over());
  box.setInformativeText(
      (sightings == 1 ? DialogsText::tr("Its one typed sighting is deleted with it.")
                      : DialogsText::tr("Its %1 typed sightings are deleted with it.").arg(sightings)) +
      u' ' + DialogsText::tr("Edit › Undo brings them back."));
  const QPushButton* remove = box.addButton(DialogsText::tr("&Delete"), QMessageBox::AcceptRole);
  box.setDefaultButton(QMessageBox::Cancel);
  makeSafeButton(*qobject_cast<QPushButton*>(box.button(QMessageBox::Cancel)));
  box.exec();
  return box.clickedButton() == remove;
}

QString Dialogs::askOpenPath(const QString& folder) {
  return QFileDialog::getOpenFileName(
      m_parent, DialogsText::tr("Open session"), folder,
      DialogsText::tr("Sessions and reports (*.alidade *.pdf);;Sessions (*.alidade);;"
                      "Reports with a session in them (*.pdf);;All files (*)"));
}

QStringList Dialogs::askImportPaths(const QString& folder) {
  return QFileDialog::getOpenFileNames(
      m_parent, DialogsText::tr("Import readings"), folder,
      DialogsText::tr("Readings (%1);;All files (*)").arg(readingsPatterns()));
}

std::optional<ImportDecision> Dialogs::askImport(ImportRequest request) {
  return ImportPage(std::move(request), m_parent).ask();
}

QString Dialogs::askRecordPath(const QString& folder) {
  return QFileDialog::getOpenFileName(
      m_parent, DialogsText::tr("Take from the instrument record"), folder,
      DialogsText::tr("Instrument records (*.alidade-instrument);;All files (*)"));
}

QString Dialogs::askProtocolPath(const QString& folder) {
  return QFileDialog::getOpenFileName(
      m_parent, DialogsText::tr("Follow a protocol"), folder,
      DialogsText::tr("Measurement protocols (*.alidade-protocol);;All files (*)"));
}

std::optional<SightingProtocol> Dialogs::askProtocol(const SightingProtocol& protocol, CircleUnit unit) {
  ProtocolDialog dialog(protocol, unit, m_parent);
  return dialog.exec() == QDialog::Accepted ? dialog.protocol() : std::nullopt;
}

std::optional<OwnEffect> Dialogs::askOwnEffect(const Session& session, const OwnEffect& effect) {
  OwnEffectDialog dialog(session, effect, *this, m_parent);
  return dialog.exec() == QDialog::Accepted ? std::optional(dialog.effect()) : std::nullopt;
}

QWidget* Dialogs::over() const {
  QWidget* active = QApplication::activeWindow();
  const bool isBeside = active && m_parent && active->parentWidget() == m_parent && !active->isModal();
  return isBeside ? active : m_parent.data();
}

QString Dialogs::askFolder(const QString& title, const QString& folder) {
  return QFileDialog::getExistingDirectory(over(), title, folder);
}

QStringList Dialogs::askSessionPaths(const QString& folder) {
  return QFileDialog::getOpenFileNames(over(), DialogsText::tr("Add sessions"), folder,
                                       DialogsText::tr("Sessions (*.alidade);;All files (*)"));
}

QString Dialogs::askSavePath(const QString& suggestion) {
  return saveFile(m_parent, DialogsText::tr("Save session as"), suggestion, sessionFilter(),
                  QStringLiteral("alidade"));
}

QString Dialogs::askReportPath(const QString& suggestion) {
  return saveFile(over(), DialogsText::tr("Export acceptance report"), suggestion,
                  DialogsText::tr("PDF (*.pdf)"), QStringLiteral("pdf"));
}

QString Dialogs::askExportPath(const QString& title, const QString& suggestion, const QString& suffix) {
  return saveFile(over(), title, suggestion, QStringLiteral("%1 (*.%2)").arg(suffix.toUpper(), suffix),
                  suffix);
}

std::optional<ReportChoice> Dialogs::askReport(const ReportQuestion& question) {
  ReportDialog dialog(question, m_parent);
  if (dialog.exec() != QDialog::Accepted) return {};
  return dialog.choice();
}

bool Dialogs::askPaper(ReportPaper& paper) {
  return ui::askPaper(m_parent, paper);
}

bool Dialogs::askPrinter(QPrinter& printer, const QString& title) {
  QPrintDialog dialog(&printer, m_parent);
  dialog.setWindowTitle(title);
  dialog.setOption(QAbstractPrintDialog::PrintPageRange, false);
  return dialog.exec() == QDialog::Accepted;
}

PreviewAnswer Dialogs::showPreview(QPrinter& printer, const std::function<void(QPrinter&)>& paint,
                                   const PreviewChange& change) {
  return PrintPreview(printer, paint, change, m_parent).ask();
}

QString Dialogs::askSeal(const QString& suggestion) {
  QDialog dialog(m_parent);
  dialog.setWindowTitle(DialogsText::tr("Seal"));
  QLabel* says = createPlainLabel(DialogsText::tr(
      "The journal records who seals this session, and a digest of its content.\nThe session can be edited "
      "afterwards as a revision; the journal records every edit.\n\nSealed by:"));
  auto* by = new QLineEdit(suggestion);
  by->setPlaceholderText(DialogsText::tr("name"));
  says->setBuddy(by);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  const auto enable = [by, ok = buttons->button(QDialogButtonBox::Ok)] {
    ok->setEnabled(!by->text().trimmed().isEmpty());
  };
  QObject::connect(by, &QLineEdit::textChanged, &dialog, enable);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  enable();
  auto* layout = new QVBoxLayout(&dialog);
  for (QWidget* part : std::initializer_list<QWidget*>{says, by, buttons}) layout->addWidget(part);
  by->setFocus();
  return dialog.exec() == QDialog::Accepted ? by->text().trimmed() : QString();
}

bool Dialogs::askOpenElsewhere(const QString& name, const QString& holder) {
  QMessageBox box(QMessageBox::Warning, DialogsText::tr("Already open"),
                  DialogsText::tr("“%1” is open in another window (%2).").arg(name, holder),
                  QMessageBox::Cancel, m_parent);
  box.setTextFormat(Qt::PlainText);
  box.setInformativeText(
      DialogsText::tr("Changes saved in one window do not appear in the other. Each window asks before it "
                      "overwrites the other's changes."));
  const QAbstractButton* anyway = box.addButton(DialogsText::tr("&Go On"), QMessageBox::AcceptRole);
  box.setDefaultButton(QMessageBox::Cancel);
  makeSafeButton(*qobject_cast<QPushButton*>(box.button(QMessageBox::Cancel)));
  box.exec();
  return box.clickedButton() == anyway;
}

ChangedFileAnswer Dialogs::askChangedFile(const ChangedFile& file) {
  return ui::askChangedFile(m_parent, file);
}

RecoveryAnswer Dialogs::askRecovery(const QList<RecoveryOffer>& offers) {
  return RecoveryDialog(offers, m_parent).ask();
}

void Dialogs::showProblem(const QString& title, const QString& text) {
  QMessageBox box(QMessageBox::Warning, title, boxText(text), QMessageBox::Ok, over());
  box.setTextInteractionFlags(Qt::TextSelectableByMouse);
  box.exec();
}

std::unique_ptr<Busy> Dialogs::busy(const QString& doing, Busy::Way way) {
  return std::make_unique<Busy>(m_parent, doing, way);
}

bool Dialogs::askPreferences() {
  return PreferencesDialog(*this, m_parent).exec() == QDialog::Accepted;
}

std::optional<QFont> Dialogs::askFont(const QFont& now) {
  bool isChosen = false;
  const QFont font = QFontDialog::getFont(&isChosen, now, m_parent, DialogsText::tr("Font of the window"),
                                          QFontDialog::DontUseNativeDialog);
  return isChosen ? std::optional(font) : std::nullopt;
}

void Dialogs::showAbout() {
  QMessageBox box(
      QMessageBox::NoIcon, DialogsText::tr("About Alidade"),
      DialogsText::tr(
          "<h3>Alidade %1</h3><p>A measurement workstation for rotatable arc guideways: it computes the "
          "intersection and the verdict from sightings.</p><p>Licence: GNU General Public License, version 3 "
          "or later. Alidade comes without any warranty.</p><p>Built with Qt %2.</p>")
          .arg(QCoreApplication::applicationVersion(), QString::fromLatin1(qVersion())),
      QMessageBox::Close, m_parent);
  box.setTextFormat(Qt::RichText);
  box.setIconPixmap(themeIcon(QStringLiteral("alidade")).pixmap(64, 64));
  box.exec();
}

void Dialogs::showShortcuts() {
  const QString rows[][2] = {
      {DialogsText::tr("Type"), DialogsText::tr("overwrites the cell")},
      {DialogsText::tr("Enter"),
       DialogsText::tr("accepts the entry; goes to vertical, then to the next row")},
      {DialogsText::tr("Tab, Shift+Tab"),
       DialogsText::tr("accepts the entry; goes to the next or previous shown column")},
      {DialogsText::tr("F2"), DialogsText::tr("edits what was typed")},
      {DialogsText::tr("Esc"), DialogsText::tr("discards the unfinished entry")},
      {DialogsText::tr("Space"), DialogsText::tr("excludes or includes the selected rows")},
      {DialogsText::tr("F7"), DialogsText::tr("goes to the next reading that looks misread")},
      {DialogsText::tr("F8"), DialogsText::tr("enters the reading that was probably meant")},
      {DialogsText::tr("Delete"), DialogsText::tr("clears the selected cells")},
      {DialogsText::tr("Ctrl+I, Ctrl+−"), DialogsText::tr("inserts a row above; deletes the selected rows")},
      {DialogsText::tr("Ctrl+C, Ctrl+X, Ctrl+V"),
       DialogsText::tr("copies, cuts, pastes blocks of cells, also from and to spreadsheets")},
      {DialogsText::tr("Ctrl+Shift+V"), DialogsText::tr("imports the clipboard after asking for its layout")},
      {DialogsText::tr("Ctrl+Z, Ctrl+Shift+Z"), DialogsText::tr("undo, redo")},
      {DialogsText::tr("3415224"), DialogsText::tr("means 341°52′24″; digits only, as on a number pad")},
  };
  QString html = QStringLiteral("<table cellpadding='3'>");
  for (const auto& row : rows)
    html += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>").arg(row[0], row[1]);
  QMessageBox box(QMessageBox::NoIcon, DialogsText::tr("Keys of the table"),
                  html + QStringLiteral("</table>"), QMessageBox::Close, m_parent);
  box.setTextFormat(Qt::RichText);
  box.exec();
}

}  // namespace alidade::ui
