#include "ui/recovery/form_draft.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSpinBox>

#include "ui/recovery/drafts.h"

namespace alidade::ui {

namespace {

const QLatin1String ofKey("of"), entriesKey("entries");

}  // namespace

FormDraft::FormDraft(const QString& form, const QString& of, QObject* parent)
    : QObject(parent), m_form(form), m_of(of) {
  const QJsonObject draft = drafts().of(form);
  if (draft.value(ofKey).toString() == of) m_found = draft.value(entriesKey).toObject();
}

QJsonValue FormDraft::kept(const QString& key, const QJsonValue& held) {
  const QJsonValue value = m_found.value(key);
  if (value.type() != held.type() || value == held) return QJsonValue::Undefined;
  m_isRestored = true;
  m_entries[key] = value;
  return value;
}

void FormDraft::set(const QString& key, const QJsonValue& value) {
  m_entries[key] = value;
  drafts().set(m_form, {{ofKey, m_of}, {entriesKey, m_entries}});
}

void FormDraft::add(const QString& key, QLineEdit& entry) {
  if (const QJsonValue value = kept(key, entry.text()); !value.isUndefined()) entry.setText(value.toString());
  connect(&entry, &QLineEdit::textEdited, this, [this, key](const QString& text) { set(key, text); });
}

void FormDraft::add(const QString& key, QSpinBox& entry) {
  if (const QJsonValue value = kept(key, entry.value()); !value.isUndefined()) entry.setValue(value.toInt());
  connect(&entry, &QSpinBox::valueChanged, this, [this, key](int value) { set(key, value); });
}

void FormDraft::add(const QString& key, QDoubleSpinBox& entry) {
  if (const QJsonValue value = kept(key, entry.value()); !value.isUndefined())
    entry.setValue(value.toDouble());
  connect(&entry, &QDoubleSpinBox::valueChanged, this, [this, key](double value) { set(key, value); });
}

void FormDraft::add(const QString& key, QComboBox& entry) {
  if (const QJsonValue value = kept(key, entry.currentIndex()); !value.isUndefined())
    entry.setCurrentIndex(value.toInt());
  connect(&entry, &QComboBox::currentIndexChanged, this, [this, key](int index) { set(key, index); });
}

void FormDraft::add(const QString& key, QCheckBox& entry) {
  if (const QJsonValue value = kept(key, entry.isChecked()); !value.isUndefined())
    entry.setChecked(value.toBool());
  connect(&entry, &QCheckBox::toggled, this, [this, key](bool isOn) { set(key, isOn); });
}

void FormDraft::finish() {
  m_found = {};
  m_entries = {};
  drafts().set(m_form, {});
}

void FormDraft::finishWith(const QDialog& dialog) {
  connect(&dialog, &QDialog::finished, this, &FormDraft::finish);
}

}  // namespace alidade::ui
