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

/// The entries of a form as they are typed, kept among the process's `Drafts` until the form is handed in or
/// given up. What an ended process left of a form of this name is put into each entry as it is added.
class FormDraft : public QObject {
  Q_OBJECT

 public:
  /// `of`: what the form is about, such as the files of an import; what is kept of another is not put in.
  FormDraft(const QString& form, const QString& of, QObject* parent);

  /// `key`: the same for this entry in every process.
  void add(const QString& key, QLineEdit& entry);
  void add(const QString& key, QSpinBox& entry);
  void add(const QString& key, QDoubleSpinBox& entry);
  void add(const QString& key, QComboBox& entry);
  void add(const QString& key, QCheckBox& entry);

  /// Was anything put into an entry that it did not hold?
  bool isRestored() const { return m_isRestored; }
  /// The form was handed in or given up.
  void finish();
  /// Finished as soon as `dialog` is closed in any way but by the end of the process.
  void finishWith(const QDialog& dialog);

 private:
  /// What is kept of the entry; undefined where nothing is, or what the entry holds.
  QJsonValue kept(const QString& key, const QJsonValue& held);
  void set(const QString& key, const QJsonValue& value);

  QString m_form, m_of;
  QJsonObject m_found;    ///< of an ended process
  QJsonObject m_entries;  ///< those that were changed
  bool m_isRestored = false;
};

}  // namespace alidade::ui
