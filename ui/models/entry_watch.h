#pragma once

#include <QObject>
#include <QString>
#include <cstddef>

#include "ui/document/reading_column.h"
#include "ui/jobs/fit_job.h"

namespace alidade::ui {

class SessionDocument;
struct SessionChange;

/// Compares each typed reading with the expected reading, so that a gross error is noticed while the
/// telescope still points at the target.
class EntryWatch : public QObject {
  Q_OBJECT

 public:
  explicit EntryWatch(SessionDocument& document, QObject* parent = nullptr);

  void setEvaluation(const SharedEvaluation& evaluation) { m_before = evaluation; }

 signals:
  /// A reading of the next row was typed; `doubt` is empty if the reading is as expected or none is expected.
  void entered(std::size_t position, std::size_t row, alidade::ui::ReadingColumn column,
               const QString& doubt);

 private:
  void look(const SessionChange& change);
  QString doubtOf(const NextReading& next, ReadingColumn column, const std::string& typed) const;

  SessionDocument& m_document;
  SharedEvaluation m_before;  ///< null before the first evaluation
};

}  // namespace alidade::ui
