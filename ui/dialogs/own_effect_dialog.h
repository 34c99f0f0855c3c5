#pragma once

#include <QDialog>
#include <QList>
#include <optional>
#include <string>

#include "core/session/measurement.h"
#include "core/session/own_effect.h"
#include "core/session/session.h"
#include "core/terms/formula.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace alidade::ui {

class Dialogs;
class OwnEffectCurve;

/// Edits a user's own effect and checks each change. A fault of the formula is marked at its place; for a
/// valid formula, the dialog states how clearly the session's readings can show the effect.
class OwnEffectDialog : public QDialog {
  Q_OBJECT

 public:
  OwnEffectDialog(const Session& session, OwnEffect effect, Dialogs& dialogs, QWidget* parent = nullptr);

  /// The effect as typed.
  OwnEffect effect() const;

 private:
  void check();
  void showAmplitudes(const Formula& formula);
  QString sizeMissing() const;
  void markFault(const FormulaFault* fault);
  void saveAsFile();

  Dialogs& m_dialogs;
  std::string m_title, m_device, m_instrument;
  std::optional<Measurement> m_measurement;
  OwnEffect m_start;
  QLineEdit *m_name, *m_remedy;
  QPlainTextEdit* m_formula;
  QComboBox* m_owner;
  QCheckBox* m_turns;
  QLabel* m_remark;
  QDialogButtonBox* m_buttons;
  QFormLayout* m_sizes;
  OwnEffectCurve* m_curve;
  struct Size {
    std::string name;
    QLineEdit* entry;
  };
  QList<Size> m_amplitudes;
};

}  // namespace alidade::ui
