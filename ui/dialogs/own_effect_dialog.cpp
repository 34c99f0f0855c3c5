#include "ui/dialogs/own_effect_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "core/diagnosis/own_effect_check.h"
#include "core/session/own_effects.h"
#include "ui/charts/gap/own_effect_curve.h"
#include "ui/dialogs/written_file.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

std::string typedIn(const QLineEdit& entry) {
  return entry.text().trimmed().toStdString();
}

QString visibilityText(const OwnEffectCheck& check) {
  QStringList says;
  for (const OwnVisibility& parameter : check.parameters)
    //: %1: an amplitude; %3: a unit
    says.append(OwnEffectDialog::tr("Trace of %1: %2 σ per %3, %4 σ at the plausible size.")
                    .arg(qText(parameter.parameter), numberText(parameter.perUnit, 1),
                         unitText(parameter.unit), numberText(parameter.plausible, 1)));
  for (const std::string& sentence : check.sentences()) says.append(qText(sentence));
  return says.join(u' ');
}

}  // namespace

OwnEffectDialog::OwnEffectDialog(const Session& session, OwnEffect effect, Dialogs& dialogs, QWidget* parent)
    : QDialog(parent),
      m_dialogs(dialogs),
      m_title(session.title),
      m_device(session.device.serial),
      m_instrument(session.instrument.serial),
      m_measurement(examine(session).measurement),
      m_start(std::move(effect)),
      m_name(new QLineEdit(qText(m_start.name))),
      m_remedy(new QLineEdit(qText(m_start.remedy))),
      m_formula(new QPlainTextEdit(qText(m_start.formula))),
      m_owner(new QComboBox),
      m_turns(new QCheckBox(tr("Opposite &sign in face 2"))),
      m_remark(new QLabel),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)),
      m_sizes(new QFormLayout),
      m_curve(new OwnEffectCurve) {
  setWindowTitle(tr("Effect of Your Own"));
  m_formula->setPlaceholderText(QStringLiteral("radial = A*bump(s, 83°, 4°)"));
  m_formula->setTabChangesFocus(true);
  m_formula->setAccessibleName(tr("Formula"));
  m_formula->setFixedHeight(5 * fontMetrics().lineSpacing());
  m_owner->addItem(tr("no owner: for every session"));
  if (!m_device.empty()) m_owner->addItem(tr("device %1").arg(qText(m_device)), QStringLiteral("device"));
  if (!m_instrument.empty())
    m_owner->addItem(tr("instrument %1").arg(qText(m_instrument)), QStringLiteral("instrument"));
  const QString owner = !m_start.device.empty()       ? QStringLiteral("device")
                        : !m_start.instrument.empty() ? QStringLiteral("instrument")
                                                      : QString();
  m_owner->setCurrentIndex(std::max(m_owner->findData(owner), 0));
  m_turns->setChecked(m_start.turnsWithFace);
  m_remark->setWordWrap(true);
  m_remark->setMinimumHeight(4 * fontMetrics().lineSpacing());
  m_remark->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_remark->setObjectName(QStringLiteral("effect remark"));
  auto* save = m_buttons->addButton(tr("Save as &File…"), QDialogButtonBox::ActionRole);
  auto* form = new QFormLayout(this);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Name"), m_name);
  form->addRow(tr("&Formula"), m_formula);
  form->addRow(m_turns);
  form->addRow(tr("Plausible sizes, 1σ"), m_sizes);
  form->addRow(tr("&Owner"), m_owner);
  form->addRow(tr("&Remedy"), m_remedy);
  form->addRow(m_remark);
  form->addRow(m_curve);
  form->addRow(m_buttons);
  setMinimumWidth(60 * fontMetrics().averageCharWidth());
  connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(save, &QPushButton::clicked, this, &OwnEffectDialog::saveAsFile);
  connect(m_formula, &QPlainTextEdit::textChanged, this, &OwnEffectDialog::check);
  connect(m_name, &QLineEdit::textChanged, this, &OwnEffectDialog::check);
  connect(m_turns, &QCheckBox::toggled, this, &OwnEffectDialog::check);
  check();
}

OwnEffect OwnEffectDialog::effect() const {
  OwnEffect typed = m_start;
  typed.name = typedIn(*m_name);
  if (typed.name != m_start.name || typed.id.empty()) typed.id = ownIdFrom(typed.name);
  typed.formula = m_formula->toPlainText().toStdString();
  typed.remedy = typedIn(*m_remedy);
  typed.turnsWithFace = m_turns->isChecked();
  const QString owner = m_owner->currentData().toString();
  typed.device = owner == QStringLiteral("device") ? m_device : std::string();
  typed.instrument = owner == QStringLiteral("instrument") ? m_instrument : std::string();
  typed.parameters.clear();
  for (const Size& size : m_amplitudes)
    typed.parameters.push_back({.name = size.name, .plausible = typedIn(*size.entry)});
  return typed;
}

/// Checks the formula, then the other entries, then how clearly the readings can show the effect.
void OwnEffectDialog::check() {
  const std::string text = m_formula->toPlainText().toStdString();
  const Result<Formula, FormulaFault> formula = parseFormula(text);
  markFault(formula ? nullptr : &formula.problem());
  if (formula) showAmplitudes(*formula);
  std::optional<OwnEffectCheck> shown;
  QString says;
  bool isSound = false;
  if (!formula) {
    says = qText(formula.problem().text(text));
  } else if (const QString missing = sizeMissing(); !missing.isEmpty()) {
    //: %1: an amplitude of a formula
    says = tr("Type a plausible size of %1, 1σ.").arg(missing);
  } else if (const auto problem = ownEffectProblem(effect())) {
    says = qText(problem->text());
  } else {
    isSound = true;
    if (m_measurement) shown = checkOwnEffect(*m_measurement, effect());
    if (shown) says = visibilityText(*shown);
  }
  m_remark->setText(says);
  m_curve->setCurves(shown ? shown->curves : std::vector<OwnCurve>());
  for (QAbstractButton* button : m_buttons->buttons())
    if (m_buttons->buttonRole(button) != QDialogButtonBox::RejectRole) button->setEnabled(isSound);
}

/// The first amplitude without a plausible size; empty: none.
QString OwnEffectDialog::sizeMissing() const {
  for (const Size& size : m_amplitudes)
    if (typedIn(*size.entry).empty()) return qText(size.name);
  return {};
}

/// Shows an entry for each amplitude; amplitudes that remain keep their typed size.
void OwnEffectDialog::showAmplitudes(const Formula& formula) {
  const auto isSame = [](const FormulaAmplitude& amplitude, const Size& size) {
    return amplitude.name == size.name;
  };
  if (std::ranges::equal(formula.amplitudes, m_amplitudes, isSame)) return;
  const QList<Size> before = std::exchange(m_amplitudes, {});
  const auto plausible = [&](const std::string& name) {
    for (const Size& size : before)
      if (size.name == name) return size.entry->text();
    for (const OwnParameter& parameter : m_start.parameters)
      if (parameter.name == name) return qText(parameter.plausible);
    return QString();
  };
  QStringList texts;
  for (const FormulaAmplitude& amplitude : formula.amplitudes) texts.append(plausible(amplitude.name));
  while (m_sizes->rowCount() > 0) m_sizes->removeRow(0);
  for (std::size_t i = 0; i < formula.amplitudes.size(); ++i) {
    const FormulaAmplitude& amplitude = formula.amplitudes[i];
    auto* entry = new QLineEdit(texts[static_cast<int>(i)]);
    const QString unit = unitText(std::string(unitOf(amplitude.carrier)));
    //: an amplitude of a formula and its unit: A (mm)
    m_sizes->addRow(tr("%1 (%2)").arg(qText(amplitude.name), unit), entry);
    connect(entry, &QLineEdit::textChanged, this, &OwnEffectDialog::check);
    m_amplitudes.append({amplitude.name, entry});
  }
  QWidget* last = m_turns;
  for (const Size& size : m_amplitudes) {
    setTabOrder(last, size.entry);
    last = size.entry;
  }
  setTabOrder(last, m_owner);
}

void OwnEffectDialog::markFault(const FormulaFault* fault) {
  QList<QTextEdit::ExtraSelection> marks;
  if (fault) {
    const QByteArray bytes = m_formula->toPlainText().toUtf8();
    const auto characters = [&](std::size_t at) {
      return static_cast<int>(QString::fromUtf8(bytes.left(static_cast<qsizetype>(at))).size());
    };
    QTextEdit::ExtraSelection mark;
    mark.format.setUnderlineStyle(QTextCharFormat::SpellCheckUnderline);
    mark.format.setUnderlineColor(Qt::red);
    mark.cursor = m_formula->textCursor();
    mark.cursor.setPosition(characters(fault->at));
    mark.cursor.setPosition(characters(fault->at + fault->length), QTextCursor::KeepAnchor);
    marks.append(mark);
  }
  m_formula->setExtraSelections(marks);
}

void OwnEffectDialog::saveAsFile() {
  writeToChosenPath(m_dialogs, tr("Save Effect"),
                    m_name->text().trimmed() + QStringLiteral(".alidade-effect"),
                    QStringLiteral("alidade-effect"), writeOwnEffect(effect()));
}

}  // namespace alidade::ui
