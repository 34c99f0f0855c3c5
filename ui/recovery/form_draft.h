#pragma once

#include <QJsonObject>
#include <QObject>
#include <QString>

class QCheckBox;
class QComboBox;
class QDialog;
class QDoubleSpinBox;
class QLineEdit;
class QSpinBox;

namespace alidade::ui {

/// The entries of a form being typed, stored in the process's `Drafts` until the form is accepted or
/// cancelled. A draft of a terminated process for this form name is restored entry by entry as entries are
/// added.
class FormDraft : public QObject {
  Q_OBJECT

 public:
  /// `of`: the subject of the form, such as the files of an import; drafts of another subject are not
  /// restored.
  FormDraft(const QString& form, const QString& of, QObject* parent);

  /// `key` identifies the entry, also in a later process.
  void add(const QString& key, QLineEdit& entry);
  void add(const QString& key, QSpinBox& entry);
  void add(const QString& key, QDoubleSpinBox& entry);
  void add(const QString& key, QComboBox& entry);
  void add(const QString& key, QCheckBox& entry);

  /// True if a restored value differed from that of its entry.
  bool isRestored() const { return m_isRestored; }
  /// Removes the draft, because the form was accepted or cancelled.
  void finish();
  /// Finishes when `dialog` closes in any way except by the end of the process.
  void finishWith(const QDialog& dialog);

 private:
  /// The stored value of the entry; undefined if it is absent or equal to `held`, the entry's own value.
  QJsonValue kept(const QString& key, const QJsonValue& held);
  void set(const QString& key, const QJsonValue& value);

  QString m_form, m_of;
  QJsonObject m_found;    ///< entries of the draft found when this form opened
  QJsonObject m_entries;  ///< changed entries
  bool m_isRestored = false;
};

}  // namespace alidade::ui
