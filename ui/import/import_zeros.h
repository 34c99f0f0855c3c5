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

/// The pointing zeros of the positions that an import fills: as the files or the session have them, else to
/// be typed.
class ImportZeros : public QWidget {
  Q_OBJECT

 public:
  /// `draft` keeps what is typed, until the import is done or given up.
  explicit ImportZeros(FormDraft& draft);

  /// Null: nothing can be imported.
  void show(const Import* import);
  /// Puts what was typed into the positions that have no zero; bare numbers get the session's unit.
  void enterInto(Session& session) const;
  /// Why something typed is no pointing zero; empty where all is well.
  QString problem() const { return m_problem; }

 signals:
  void typed();

 private:
  struct Row {
    QLabel* label;
    QLineEdit *horizontal, *vertical;
    std::size_t position;  ///< of the session
    bool isTyped;          ///< else it is there already
  };

  Row& rowOf(const QString& name);
  void check();
  void mark(QLineEdit& edit, const std::string& problem, const QString& name);
  std::string entered(const QLineEdit& edit) const;

  FormDraft& m_draft;
  QGridLayout* m_grid;
  std::map<QString, Row> m_rows;  ///< by the name of the position
  VerticalCircle m_circle = VerticalCircle::Zenith;
  CircleUnit m_unit = CircleUnit::Dms;
  QString m_problem;
};

}  // namespace alidade::ui
