#pragma once

#include <QWidget>
#include <cstddef>
#include <vector>

#include "core/evaluation/evaluation.h"
#include "ui/forms/field_edit.h"

class QGridLayout;
class QLabel;
class QToolButton;

namespace alidade::ui {

/// Shows the pointing zero and the axis of one position; on demand, also the further sightings of the zero in
/// face 2 and after the readings. Below follows the mean of all sightings of the zero.
class ZeroEntries : public QWidget {
  Q_OBJECT

 public:
  ZeroEntries(SessionDocument& document, std::size_t position, QWidget* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation);
  void showFurther(bool shown);
  bool hasFurther() const;  ///< true if the position has a text of a further sighting

 signals:
  void furtherWanted(bool shown);
  void entered();  ///< Enter ended the vertical reading of a sighting, its last one

 private:
  FieldEdit* addEntry(int row, int column, const std::string& field, const QString& accessible,
                      const QString& hint, FieldEdit::Shows shows = FieldEdit::Shows::Angle);
  void reportEnteredBy(FieldEdit* vertical);
  QLabel* addCaption(int row, int column, const QString& caption, QWidget* buddy);
  void addFurther(int row, const std::string& key, const QString& caption, const QString& when);

  SessionDocument& m_document;
  const std::size_t m_position;
  QGridLayout* m_layout;
  QToolButton* m_toggle;
  QLabel* m_mean;
  std::vector<QWidget*> m_further;
};

}  // namespace alidade::ui
