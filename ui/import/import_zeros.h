#pragma once

#include <QWidget>
#include <map>
#include <optional>
#include <string>

#include "core/exchange/import.h"

class QGridLayout;
class QLabel;
class QLineEdit;

namespace alidade::ui {

class FormDraft;

/// The pointing zeros of the positions filled by an import: from the files or the session, else to be typed.
class ImportZeros : public QWidget {
  Q_OBJECT

 public:
  /// `draft` keeps the typed texts until the import is done or cancelled.
  explicit ImportZeros(FormDraft& draft);

  /// Shows the zeros of `import`; null: nothing can be imported.
  void show(const Import* import);
  /// Writes the typed zeros into positions without one; bare numbers get the session's unit.
  void enterInto(Session& session) const;
  /// Returns the reason why a typed zero is invalid; empty if all are valid.
  QString problem() const { return m_problem; }

 signals:
  void typed();

 private:
  struct Row {
    QLabel* label;
    QLineEdit *horizontal, *vertical;
    std::size_t position;  ///< index in the session
    bool isTyped;          ///< false: the zero exists already
  };

  Row& rowOf(const QString& name);
  void check();
  void mark(QLineEdit& edit, const std::string& problem, const QString& name);
  std::string entered(const QLineEdit& edit) const;

  FormDraft& m_draft;
  QGridLayout* m_grid;
  std::map<QString, Row> m_rows;  ///< by position name
  VerticalCircle m_circle = VerticalCircle::Zenith;
  CircleUnit m_unit = CircleUnit::Dms;
  QString m_problem;
};

}  // namespace alidade::ui
