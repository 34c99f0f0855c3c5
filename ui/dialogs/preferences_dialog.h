#pragma once

#include <QDialog>

#include "ui/document/session_document.h"
#include "ui/settings/window_font.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QTabWidget;

namespace alidade::ui {

class Dialogs;
class LogoForm;
class PaperForm;

/// The settings of this program on this machine: the window, what new sessions start with, and the report.
/// Accepting stores all settings and applies the settings that need no restart. If an entry is unusable, the
/// dialog stays open and shows this entry.
class PreferencesDialog : public QDialog {
  Q_OBJECT

 public:
  explicit PreferencesDialog(Dialogs& dialogs, QWidget* parent = nullptr);

  void accept() override;

 private:
  QWidget* createWindowPage();
  QWidget* createFontRow();
  QWidget* createSessionPage();
  QWidget* createProtocolRow();
  QWidget* createReportPage();
  bool isUsable();
  void chooseFont(const FontChoice& choice);
  void showProtocol();

  Dialogs& m_dialogs;
  SessionDocument m_template;  ///< edited by the page of new sessions
  FontChoice m_font;
  QTabWidget* m_pages;
  QComboBox *m_language = nullptr, *m_theme = nullptr, *m_reportLanguage = nullptr;
  QCheckBox* m_tone = nullptr;
  QLabel *m_fontName = nullptr, *m_protocolName = nullptr;
  QWidget *m_desktopFont = nullptr, *m_noProtocol = nullptr;  ///< the buttons that reset a choice
  PaperForm* m_paper = nullptr;
  LogoForm* m_logo = nullptr;
};

}  // namespace alidade::ui
